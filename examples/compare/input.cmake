# compare_input: scenes, families and exact numbers of the compare program, as a static library that its tests link too.
set(GRAZE_EMBEDDED_SCENE ${CMAKE_CURRENT_LIST_DIR}/../scenes/pool_break.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${GRAZE_EMBEDDED_SCENE})
file(READ ${GRAZE_EMBEDDED_SCENE} GRAZE_EMBEDDED_SCENE_TEXT)
configure_file(${CMAKE_CURRENT_LIST_DIR}/default_scene_text.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/default_scene_text.cpp @ONLY)

find_package(nlohmann_json 3.11 REQUIRED)
add_library(compare_input STATIC
  ${CMAKE_CURRENT_LIST_DIR}/default_scene.cpp
  ${CMAKE_CURRENT_LIST_DIR}/exact_text.cpp
  ${CMAKE_CURRENT_LIST_DIR}/input_error.cpp
  ${CMAKE_CURRENT_LIST_DIR}/integer_pairs.cpp
  ${CMAKE_CURRENT_LIST_DIR}/families.cpp
  ${CMAKE_CURRENT_LIST_DIR}/json_tree.cpp
  ${CMAKE_CURRENT_LIST_DIR}/json_value.cpp
  ${CMAKE_CURRENT_LIST_DIR}/pairs.cpp
  ${CMAKE_CURRENT_LIST_DIR}/rounding.cpp
  ${CMAKE_CURRENT_LIST_DIR}/scene_reader.cpp
  ${CMAKE_CURRENT_BINARY_DIR}/default_scene_text.cpp)
target_include_directories(compare_input PUBLIC ${CMAKE_CURRENT_LIST_DIR})
target_link_libraries(compare_input
  PUBLIC graze::graze graze_number_boost
  PRIVATE graze_warnings nlohmann_json::nlohmann_json)

# What is not measured need not be fast: it is optimised less in a release. (The linker takes an inline function from the
# first object that has it, which are those of the measured types: libraries come last.) Boost's numbers, which nearly
# every file includes, are compiled once.
set(boost_numbers <boost/multiprecision/cpp_int.hpp> <boost/multiprecision/cpp_bin_float.hpp>)
function(compare_compile_quickly)
    foreach(target IN LISTS ARGN)
        target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
        if(target STREQUAL "compare_input")
            target_precompile_headers(${target} PRIVATE ${boost_numbers})
        else()
            target_precompile_headers(${target} REUSE_FROM compare_input)
        endif()
    endforeach()
endfunction()
compare_compile_quickly(compare_input)

# Writes examples/scenes/*.json again.
add_executable(generate_scenes ${CMAKE_CURRENT_LIST_DIR}/../scenes/generate.cpp)
target_compile_features(generate_scenes PRIVATE cxx_std_20)
target_link_libraries(generate_scenes PRIVATE graze_warnings)
