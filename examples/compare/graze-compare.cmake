# graze_add_compare_program(name
#     TYPES type...           number types, as C++ writes them
#     [HEADERS file...]       the headers that declare types and formulas, as <name> or as paths
#     [FORMULAS formula...]   function objects, run in each of the types: whole solutions or discriminants of two balls
#     [LIBRARIES target...]   what the types need
#     [DEFINITIONS name...]   macros for their headers
#     [EXCLUDE_FROM_ALL])     the program is built only by its own target
# makes a program of this name: graze-compare with these types and formulas as rows beside all others. A type that
# graze-compare already has adds no rows of its own, but its formulas do. All types are compiled with the build's flags.
# Needs Boost, CLI11 and nlohmann-json. If GMP, MPFR, CGAL or QD is found, its types are added;
# set(GRAZE_COMPARE_TYPES built_in) leaves out these and Boost's.
include_guard(GLOBAL)
set(GRAZE_COMPARE_SOURCES "${CMAKE_CURRENT_LIST_DIR}" CACHE INTERNAL "The sources of graze-compare")
set(GRAZE_COMPARE_KNOWN float double "long double" __float128 CACHE INTERNAL "Types that graze-compare has by name")
include("${CMAKE_CURRENT_LIST_DIR}/../../tests/precision/graze-precision.cmake") # its checks of words

function(graze_compare_libraries)
    if(TARGET compare_program)
        return()
    endif()
    include("${GRAZE_COMPARE_SOURCES}/../number_libraries.cmake")
    graze_find_number_libraries()
    if(NOT TARGET graze_number_boost)
        message(FATAL_ERROR "graze_add_compare_program: Boost.Multiprecision is not found; "
            "on Debian and Ubuntu it is the package libboost-dev")
    endif()
    foreach(package IN ITEMS CLI11 nlohmann_json)
        find_package(${package} QUIET)
        if(NOT ${package}_FOUND)
            message(FATAL_ERROR "graze_add_compare_program: ${package} is not found; "
                "on Debian and Ubuntu these are the packages libcli11-dev and nlohmann-json3-dev")
        endif()
    endforeach()
    add_subdirectory("${GRAZE_COMPARE_SOURCES}" "${CMAKE_BINARY_DIR}/graze-compare.files" EXCLUDE_FROM_ALL)
endfunction()

function(graze_add_compare_program name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "EXCLUDE_FROM_ALL" "" "TYPES;HEADERS;FORMULAS;LIBRARIES;DEFINITIONS")
    graze_precision_check_words("graze_add_compare_program(${name})" "${arg_UNPARSED_ARGUMENTS}"
        "${arg_KEYWORDS_MISSING_VALUES}")
    graze_compare_libraries()

    graze_precision_includes(includes)
    set(folder "${CMAKE_CURRENT_BINARY_DIR}/${name}.files")
    set(number 0)
    set(sources "${folder}/own_types.cpp")
    set(declarations "")
    set(calls "")
    foreach(type IN LISTS arg_TYPES)
        math(EXPR number "${number} + 1")
        set(adds "")
        set(specialised "")
        if(NOT type IN_LIST GRAZE_COMPARE_KNOWN)
            set(adds "    list.push_back(compare::own_type<measured>());\n")
            set(specialised "
template <>
struct compare::converter<measured> : compare::converter_by_access<measured> {};
template <>
struct compare::reader<measured> : compare::reader_by_access<measured> {};
")
        endif()
        foreach(formula IN LISTS arg_FORMULAS)
            string(APPEND adds "    list.push_back(compare::own_formula<${formula}, measured>(\"${formula}\"));\n")
        endforeach()
        file(CONFIGURE OUTPUT "${folder}/type_${number}.cpp" @ONLY CONTENT
"@includes@#include \"@GRAZE_COMPARE_SOURCES@/own_type.hpp\"

using measured = @type@;
@specialised@
void add_type_@number@(std::vector<compare::measurable>& list);
void add_type_@number@(std::vector<compare::measurable>& list) {
@adds@}
")
        list(APPEND sources "${folder}/type_${number}.cpp")
        string(APPEND declarations "void add_type_${number}(std::vector<compare::measurable>& list);\n")
        string(APPEND calls "    add_type_${number}(list);\n")
    endforeach()
    file(CONFIGURE OUTPUT "${folder}/own_types.cpp" @ONLY CONTENT
"#include \"@GRAZE_COMPARE_SOURCES@/own_types.hpp\"

@declarations@
std::vector<compare::measurable> compare::own_types() {
    std::vector<measurable> list;
@calls@    return list;
}
")
    set(exclude)
    if(arg_EXCLUDE_FROM_ALL)
        set(exclude EXCLUDE_FROM_ALL)
    endif()
    add_executable(${name} ${exclude} ${sources})
    get_property(objects GLOBAL PROPERTY GRAZE_COMPARE_TYPE_OBJECTS)
    target_link_libraries(${name} PRIVATE graze::graze ${arg_LIBRARIES} ${objects} compare_program graze_warnings)
    target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
endfunction()
