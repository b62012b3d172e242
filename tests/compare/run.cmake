# Certified runs and runs in number types.
set(certified certified_test.cpp certified_run_test.cpp certified_ties_test.cpp event_check_test.cpp integer_line_test.cpp)
if(TARGET graze_exact_runs AND TARGET graze_number_gmp)
    list(APPEND certified certified_points_test.cpp)
endif()
graze_add_tests_together(compare_certified_tests compare_*_test SOURCES ${certified} LIBRARIES compare_certified
    $<TARGET_NAME_IF_EXISTS:graze_exact_runs> $<TARGET_NAME_IF_EXISTS:graze_number_gmp> graze_properties)
target_compile_definitions(compare_certified_tests PRIVATE
    "GRAZE_SCENES=\"${PROJECT_SOURCE_DIR}/examples/scenes\"")
target_compile_options(compare_certified_tests PRIVATE -O0) # what takes the time is compiled elsewhere
list(TRANSFORM certified REPLACE "(_test)?\\.cpp$" "" OUTPUT_VARIABLE certified_tests)
list(TRANSFORM certified_tests REPLACE "(.+)" "compare_\\1_test")
graze_build_when_asked(matrix compare_certified_tests ${certified_tests})
add_executable(compare_certified_soak certified_soak.cpp)
target_link_libraries(compare_certified_soak PRIVATE compare_certified graze_warnings)
add_test(NAME compare_certified_soak COMMAND compare_certified_soak)
set_tests_properties(compare_certified_soak PROPERTIES TIMEOUT 300)
graze_build_when_asked(soak compare_certified_soak compare_certified_soak)
foreach(test IN ITEMS compare_certified_tests compare_certified_soak)
    target_compile_definitions(${test} PRIVATE "GRAZE_TEST_SCENES=\"${CMAKE_CURRENT_SOURCE_DIR}/scenes\"")
endforeach()
target_compile_options(compare_certified_soak PRIVATE -O0)
graze_add_test(compare_run_program_test SOURCES run_program_test.cpp LIBRARIES nlohmann_json::nlohmann_json TIMEOUT 300)
target_compile_definitions(compare_run_program_test PRIVATE
    "GRAZE_COMPARE=\"$<TARGET_FILE:graze-compare>\"" "GRAZE_SCENES=\"${PROJECT_SOURCE_DIR}/examples/scenes\""
    "GRAZE_TEST_SCENES=\"${CMAKE_CURRENT_SOURCE_DIR}/scenes\"" "GRAZE_BAD_INPUTS=\"${CMAKE_CURRENT_SOURCE_DIR}/bad\""
    "GRAZE_JSON_PAGE=\"${PROJECT_SOURCE_DIR}/docs/reference/run-json.md\"")
add_dependencies(compare_run_program_test graze-compare graze-compare-run)
set_target_properties(compare_certified compare_run_types graze-compare-run PROPERTIES EXCLUDE_FROM_ALL ON)
graze_build_when_asked(matrix compare_run_program_test compare_run_program_test)
