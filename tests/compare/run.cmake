# Certified runs and runs in number types.
find_package(rapidcheck REQUIRED)
graze_add_test(compare_certified_test SOURCES certified_test.cpp LIBRARIES compare_certified rapidcheck)
graze_add_test(compare_certified_run_test SOURCES certified_run_test.cpp LIBRARIES compare_certified)
target_compile_definitions(compare_certified_run_test PRIVATE "GRAZE_SCENES=\"${PROJECT_SOURCE_DIR}/examples/scenes\"")
target_compile_options(compare_certified_run_test PRIVATE -O0) # what takes the time is compiled elsewhere
graze_add_test(compare_run_program_test SOURCES run_program_test.cpp LIBRARIES nlohmann_json::nlohmann_json TIMEOUT 300)
target_compile_definitions(compare_run_program_test PRIVATE
    "GRAZE_COMPARE=\"$<TARGET_FILE:graze-compare>\"" "GRAZE_SCENES=\"${PROJECT_SOURCE_DIR}/examples/scenes\""
    "GRAZE_JSON_PAGE=\"${PROJECT_SOURCE_DIR}/docs/reference/run-json.md\"")
add_dependencies(compare_run_program_test graze-compare)
