# The engine, its conclusions and files, and the program as a whole.
set(parts exact_text_test.cpp score_test.cpp statistics_test.cpp true_value_test.cpp)
if(TARGET graze_number_gmp)
    list(APPEND parts pairs_test.cpp truth_test.cpp)
endif()
graze_add_tests_together(compare_parts_test compare_*_test SOURCES ${parts}
    LIBRARIES compare_engine $<TARGET_NAME_IF_EXISTS:graze_number_gmp>)
target_include_directories(compare_parts_test PRIVATE "${PROJECT_SOURCE_DIR}/tests")
graze_add_test(compare_results_test SOURCES results_test.cpp report_sample.cpp LIBRARIES compare_engine compare_report)

graze_add_test(compare_program_test SOURCES program_test.cpp LIBRARIES compare_engine nlohmann_json::nlohmann_json
    TIMEOUT 600)
target_compile_definitions(compare_program_test PRIVATE
    "GRAZE_COMPARE=\"$<TARGET_FILE:graze-compare>\"" "GRAZE_BAD_INPUTS=\"${CMAKE_CURRENT_SOURCE_DIR}/bad\""
    "GRAZE_JSON_PAGE=\"${PROJECT_SOURCE_DIR}/docs/reference/compare-json.md\"")
add_dependencies(compare_program_test graze-compare)

# With a number type and formulas of the user's.
graze_add_compare_program(compare_own TYPES own::thirty_bits HEADERS own_number.hpp
    FORMULAS own::late_solution careless_discriminant)
add_test(NAME compare_own COMMAND "${CMAKE_COMMAND}" -D "PROGRAM=$<TARGET_FILE:compare_own>"
    -D "WORK=${CMAKE_CURRENT_BINARY_DIR}/own.work" -P "${CMAKE_CURRENT_SOURCE_DIR}/own.cmake")

# The program on every scene, with numbers as written; in the matrix as doubles too.
file(GLOB scenes CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/examples/scenes/*.json")
foreach(scene IN LISTS scenes)
    get_filename_component(name "${scene}" NAME_WE)
    foreach(numbers IN ITEMS double exact)
        add_test(NAME compare_scene_${name}_${numbers}
            COMMAND graze-compare "${scene}" --as ${numbers} --types double,cpp_rational
                --variants halved/printed,lagrange/stable --timing 0.05)
        set_tests_properties(compare_scene_${name}_${numbers} PROPERTIES TIMEOUT 300
            PASS_REGULAR_EXPRESSION "cheapest")
    endforeach()
    set_tests_properties(compare_scene_${name}_double PROPERTIES LABELS matrix)
endforeach()
