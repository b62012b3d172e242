# Certified runs and runs in number types.
find_package(rapidcheck REQUIRED)
graze_add_test(compare_certified_test SOURCES certified_test.cpp LIBRARIES compare_certified rapidcheck)
graze_add_test(compare_certified_run_test SOURCES certified_run_test.cpp LIBRARIES compare_certified)
target_compile_definitions(compare_certified_run_test PRIVATE "GRAZE_SCENES=\"${PROJECT_SOURCE_DIR}/examples/scenes\"")
target_compile_options(compare_certified_run_test PRIVATE -O0) # what takes the time is compiled elsewhere
graze_add_test(compare_certified_ties_test SOURCES certified_ties_test.cpp LIBRARIES compare_certified)
if(TARGET graze_exact_runs AND TARGET graze_number_gmp)
    graze_add_test(compare_certified_points_test SOURCES certified_points_test.cpp
        LIBRARIES compare_certified graze_exact_runs graze_number_gmp)
    target_compile_options(compare_certified_points_test PRIVATE -O0)
endif()
graze_add_test(compare_event_check_test SOURCES event_check_test.cpp LIBRARIES compare_certified)
graze_add_test(compare_integer_line_test SOURCES integer_line_test.cpp LIBRARIES compare_certified rapidcheck)
add_executable(compare_certified_soak certified_soak.cpp)
target_link_libraries(compare_certified_soak PRIVATE compare_certified graze_warnings)
add_test(NAME compare_certified_soak COMMAND compare_certified_soak)
set_tests_properties(compare_certified_soak PROPERTIES LABELS soak TIMEOUT 300)
foreach(test IN ITEMS compare_certified_ties_test compare_certified_soak)
    target_compile_definitions(${test} PRIVATE "GRAZE_TEST_SCENES=\"${CMAKE_CURRENT_SOURCE_DIR}/scenes\"")
endforeach()
foreach(test IN ITEMS compare_certified_ties_test compare_event_check_test compare_certified_soak)
    target_compile_options(${test} PRIVATE -O0)
endforeach()
graze_add_test(compare_run_program_test SOURCES run_program_test.cpp LIBRARIES nlohmann_json::nlohmann_json TIMEOUT 300)
target_compile_definitions(compare_run_program_test PRIVATE
    "GRAZE_COMPARE=\"$<TARGET_FILE:graze-compare>\"" "GRAZE_SCENES=\"${PROJECT_SOURCE_DIR}/examples/scenes\""
    "GRAZE_TEST_SCENES=\"${CMAKE_CURRENT_SOURCE_DIR}/scenes\"" "GRAZE_BAD_INPUTS=\"${CMAKE_CURRENT_SOURCE_DIR}/bad\""
    "GRAZE_JSON_PAGE=\"${PROJECT_SOURCE_DIR}/docs/reference/run-json.md\"")
add_dependencies(compare_run_program_test graze-compare graze-compare-run)
