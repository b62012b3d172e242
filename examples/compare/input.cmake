# compare_input: scenes, families and exact numbers of the compare program, as a static library that its tests link too.
set(GRAZE_EMBEDDED_SCENE ${CMAKE_CURRENT_LIST_DIR}/../scenes/pool_break.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${GRAZE_EMBEDDED_SCENE})
file(READ ${GRAZE_EMBEDDED_SCENE} GRAZE_EMBEDDED_SCENE_TEXT)
configure_file(${CMAKE_CURRENT_LIST_DIR}/default_scene_text.cpp.in ${CMAKE_CURRENT_BINARY_DIR}/default_scene_text.cpp @ONLY)

find_package(nlohmann_json 3.11 REQUIRED)
set(input default_scene.cpp exact_text.cpp families.cpp input_error.cpp integer_pairs.cpp json_tree.cpp json_value.cpp
    pairs.cpp rounding.cpp scene_reader.cpp scene_writer.cpp)
add_library(compare_input STATIC ${input} ${CMAKE_CURRENT_BINARY_DIR}/default_scene_text.cpp)
target_include_directories(compare_input PUBLIC ${CMAKE_CURRENT_LIST_DIR})
target_link_libraries(compare_input
    PUBLIC graze::graze graze_number_boost
    PRIVATE graze_warnings nlohmann_json::nlohmann_json)
compare_compile_together(compare_input -O1 ${input})

if(NOT PROJECT_NAME STREQUAL "graze")
    return()
endif()
# Rewrites examples/scenes/*.json.
add_executable(generate_scenes ${CMAKE_CURRENT_LIST_DIR}/../scenes/generate.cpp)
target_compile_features(generate_scenes PRIVATE cxx_std_20)
target_link_libraries(generate_scenes PRIVATE graze_warnings)
