# graze_add_precision_test(name
#     TYPES type...           number types, as C++ writes them
#     [HEADERS file...]       the headers that declare types and formulas, as <name> or as paths
#     [FORMULAS formula...]   function objects (graze/precision/subject.hpp); all of graze's unless given
#     [DECISIONS]             graze's decisions and contacts in float and double as well, which may never be wrong
#     [FLAGS set...]          each a string of compiler flags for the formulas, after the build's own; by default
#                             "-O1 -ffp-contract=off", with which graze's own figures are measured. FLAGS " " adds none
#     [ACCEPTED folder]       the folder of the accepted figures; with AS, graze's own. Of several sets of flags, the first
#                             that should lose nothing updates them; the others are compared with its figures
#     [AS variant/type]       compare with the accepted figures of this variant and this type; either may be left out
#     [INPUTS path...]        files of kept pairs, or folders of them; graze's own unless given
#     [LIBRARIES target...]   what the types need
#     [DEFINITIONS name...]   macros for their headers
#     [PAIRS n] [SEED n]      the number of pairs drawn from each family, and the seed: 400 and 1; not with AS
#     [THREADS n]
#     [TOLERANCE p]           let the largest error exceed the accepted one by p percent; 0 unless given
#     [LABELS label...]       the tests' labels
#     [EXPECT_LOSS [flag...]] the test fails if nothing is lost; with several sets, for those with one of the flags
#     [EXCLUDE_FROM_ALL])     the programs are built when the tests run
# makes a program and a test for each set of flags, name or name.1, name.2 ...; for several sets also name.flags, a test
# that says which flag lost the precision. Needs GMP for the exact values.
#
# graze_add_hard_case_search(name
#     TYPES type... [HEADERS file...] [FORMULAS formula...] [DECISIONS] [LIBRARIES target...] [DEFINITIONS name...]
#                             as above
#     [FLAGS flags]           a string of compiler flags for the formulas, after the build's own; by default
#                             "-O1 -ffp-contract=off"
#     [EXCLUDE_FROM_ALL])     the program is built only by its own target
# makes a program that searches for hard cases of these formulas; its command line says the rest (--help). Work is counted
# in the code of FORMULAS and TYPES, headers included. Needs GMP and CLI11.
include_guard(GLOBAL)
set(GRAZE_PRECISION_FLAGS "-O1 -ffp-contract=off")
set(GRAZE_PRECISION_SOURCES "${CMAKE_CURRENT_LIST_DIR}" CACHE INTERNAL "The sources of the precision suite")

# The measuring code, compiled once, with the build's own flags except those that would spoil it.
function(graze_precision_suite_library)
    if(TARGET graze_precision_suite)
        return()
    endif()
    find_path(GRAZE_gmp_INCLUDE_DIR gmpxx.h)
    find_library(GRAZE_gmpxx_LIBRARY gmpxx)
    find_library(GRAZE_gmp_LIBRARY gmp)
    mark_as_advanced(GRAZE_gmp_INCLUDE_DIR GRAZE_gmpxx_LIBRARY GRAZE_gmp_LIBRARY)
    if(NOT GRAZE_gmp_INCLUDE_DIR OR NOT GRAZE_gmpxx_LIBRARY OR NOT GRAZE_gmp_LIBRARY)
        message(FATAL_ERROR "graze_add_precision_test: GMP (gmpxx.h, libgmpxx, libgmp) is not found; "
            "on Debian and Ubuntu it is the package libgmp-dev")
    endif()
    find_package(Threads REQUIRED)
    set(sources accepted failure inputs judge measure options reference run shrink truth which_flag)
    list(TRANSFORM sources PREPEND "${GRAZE_PRECISION_SOURCES}/")
    list(TRANSFORM sources APPEND ".cpp")
    add_library(graze_precision_suite STATIC EXCLUDE_FROM_ALL ${sources})
    target_include_directories(graze_precision_suite SYSTEM PRIVATE "${GRAZE_gmp_INCLUDE_DIR}")
    target_link_libraries(graze_precision_suite PUBLIC graze::graze
        "${GRAZE_gmpxx_LIBRARY}" "${GRAZE_gmp_LIBRARY}" Threads::Threads)
    target_compile_options(graze_precision_suite PRIVATE -O1 -fno-fast-math -ffp-contract=off)
    set_target_properties(graze_precision_suite PROPERTIES UNITY_BUILD ON) # their headers take longer than they do
    # All formulas in a number type whose time GMP takes: optimising them would only cost compile time.
    set_property(SOURCE "${GRAZE_PRECISION_SOURCES}/reference.cpp" APPEND PROPERTY COMPILE_OPTIONS -O0)
    if(TARGET graze_warnings) # the project's own build
        target_link_libraries(graze_precision_suite PRIVATE graze_warnings)
    endif()
endfunction()

# The searching code, and the command line of a search, if CLI11 is installed.
function(graze_hard_case_search_libraries)
    graze_precision_suite_library()
    find_package(CLI11 QUIET)
    set(search_sources border climb figures goal kept run work)
    set(search_program_sources program)
    set(search_links graze_precision_suite)
    set(search_program_links graze_precision_search CLI11::CLI11)
    foreach(part IN ITEMS search search_program)
        if(TARGET graze_precision_${part} OR (part STREQUAL "search_program" AND NOT TARGET CLI11::CLI11))
            continue()
        endif()
        list(TRANSFORM ${part}_sources PREPEND "${GRAZE_PRECISION_SOURCES}/search/")
        list(TRANSFORM ${part}_sources APPEND ".cpp")
        add_library(graze_precision_${part} STATIC EXCLUDE_FROM_ALL ${${part}_sources})
        target_include_directories(graze_precision_${part} SYSTEM PRIVATE "${GRAZE_gmp_INCLUDE_DIR}")
        target_link_libraries(graze_precision_${part} PUBLIC ${${part}_links})
        target_compile_options(graze_precision_${part} PRIVATE -O1 -fno-fast-math -ffp-contract=off)
        set_target_properties(graze_precision_${part} PROPERTIES UNITY_BUILD ON)
        if(TARGET graze_warnings)
            target_link_libraries(graze_precision_${part} PRIVATE graze_warnings)
        endif()
    endforeach()
endfunction()

# The #include lines of arg_HEADERS.
function(graze_precision_includes out)
    set(includes "")
    foreach(file IN LISTS arg_HEADERS)
        if(file MATCHES "^<.*>$")
            string(APPEND includes "#include ${file}\n")
        else()
            get_filename_component(file "${file}" ABSOLUTE)
            string(APPEND includes "#include \"${file}\"\n")
        endif()
    endforeach()
    set(${out} "${includes}" PARENT_SCOPE)
endfunction()

# The sources of a program: one for each type, so that they compile in parallel, and the main program, which includes the
# header and returns the call.
function(graze_precision_sources folder header call sources_out)
    graze_precision_includes(includes)
    set(declarations "")
    set(calls "")
    set(sources "${folder}/main.cpp")
    set(number 0)
    foreach(type IN LISTS arg_TYPES)
        math(EXPR number "${number} + 1")
        set(adds "graze::precision::add_formulas<measured>(list);")
        if(arg_FORMULAS)
            set(adds "")
            foreach(formula IN LISTS arg_FORMULAS)
                string(APPEND adds "graze::precision::add<${formula}, measured>(list);\n    ")
            endforeach()
        endif()
        file(CONFIGURE OUTPUT "${folder}/type_${number}.cpp" @ONLY CONTENT
"@includes@#include <graze/precision/formulas.hpp>

using measured = @type@;

void add_type_@number@(graze::precision::subjects& list);
void add_type_@number@(graze::precision::subjects& list) {
    @adds@
}
")
        list(APPEND sources "${folder}/type_${number}.cpp")
        string(APPEND declarations "void add_type_${number}(graze::precision::subjects& list);\n")
        string(APPEND calls "    add_type_${number}(list);\n")
    endforeach()
    foreach(type IN ITEMS float double)
        if(NOT arg_DECISIONS)
            break()
        endif()
        file(CONFIGURE OUTPUT "${folder}/decisions_${type}.cpp" @ONLY CONTENT
"#include <graze/precision/decisions.hpp>

void add_decisions_@type@(graze::precision::subjects& list);
void add_decisions_@type@(graze::precision::subjects& list) {
    graze::precision::add_decisions<@type@>(list);
}
")
        list(APPEND sources "${folder}/decisions_${type}.cpp")
        string(APPEND declarations "void add_decisions_${type}(graze::precision::subjects& list);\n")
        string(APPEND calls "    add_decisions_${type}(list);\n")
    endforeach()
    file(CONFIGURE OUTPUT "${folder}/main.cpp" @ONLY CONTENT
"#include \"@GRAZE_PRECISION_SOURCES@/@header@\"

@declarations@
int main(int argc, char** argv) {
    graze::precision::subjects list;
@calls@    return @call@;
}
")
    set(${sources_out} "${sources}" PARENT_SCOPE)
endfunction()

# Reports, by name, words that cmake_parse_arguments would swallow or leave over.
function(graze_precision_check_words function unparsed without_value)
    if(unparsed)
        list(GET unparsed 0 word)
        message(FATAL_ERROR "${function}: '${word}' belongs to no keyword")
    endif()
    list(REMOVE_ITEM without_value EXPECT_LOSS) # stands alone too
    if(without_value)
        list(GET without_value 0 word)
        message(FATAL_ERROR "${function}: ${word} has no value")
    endif()
    if(NOT arg_TYPES)
        message(FATAL_ERROR "${function}: TYPES is missing")
    endif()
    foreach(file IN LISTS arg_HEADERS)
        if(NOT file MATCHES "^<.*>$")
            get_filename_component(path "${file}" ABSOLUTE)
            if(NOT EXISTS "${path}")
                message(FATAL_ERROR "${function}: HEADERS ${file}: no such file")
            endif()
        endif()
    endforeach()
endfunction()

function(graze_add_precision_test name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "DECISIONS;EXCLUDE_FROM_ALL" "ACCEPTED;AS;PAIRS;SEED;THREADS;TOLERANCE"
        "TYPES;HEADERS;FORMULAS;FLAGS;INPUTS;LIBRARIES;DEFINITIONS;LABELS;EXPECT_LOSS")
    set(this_call "graze_add_precision_test(${name})")
    graze_precision_check_words("${this_call}" "${arg_UNPARSED_ARGUMENTS}" "${arg_KEYWORDS_MISSING_VALUES}")
    foreach(option IN ITEMS PAIRS SEED THREADS)
        if(DEFINED arg_${option} AND NOT arg_${option} MATCHES "^[1-9][0-9]*$")
            message(FATAL_ERROR "${this_call}: ${option} ${arg_${option}}: a whole number above 0 is needed")
        endif()
    endforeach()
    if(DEFINED arg_TOLERANCE AND NOT arg_TOLERANCE MATCHES "^[0-9]+(\\.[0-9]+)?$")
        message(FATAL_ERROR "${this_call}: TOLERANCE ${arg_TOLERANCE}: a percentage is needed")
    endif()
    if(arg_ACCEPTED AND arg_AS)
        message(FATAL_ERROR "${this_call}: ACCEPTED and AS: the figures are those of a folder of yours, or graze's own; "
            "one of the two")
    elseif(arg_AS)
        if(NOT arg_AS MATCHES "/" OR arg_AS STREQUAL "/")
            message(FATAL_ERROR "${this_call}: AS ${arg_AS}: no variant/type, such as lagrange/double or /double")
        endif()
        foreach(option IN ITEMS PAIRS SEED)
            if(DEFINED arg_${option})
                message(FATAL_ERROR "${this_call}: AS and ${option}: graze's own figures are of 400 pairs of each family, "
                    "drawn with seed 1; figures of other pairs say nothing beside them")
            endif()
        endforeach()
        set(arg_ACCEPTED "${GRAZE_PRECISION_SOURCES}/accepted")
    elseif(NOT arg_ACCEPTED)
        message(FATAL_ERROR "${this_call}: ACCEPTED, a folder, or AS is missing")
    endif()
    foreach(path IN LISTS arg_INPUTS)
        get_filename_component(absolute "${path}" ABSOLUTE)
        if(NOT EXISTS "${absolute}")
            message(FATAL_ERROR "${this_call}: INPUTS ${path}: no such file or folder")
        endif()
    endforeach()
    if(NOT arg_INPUTS)
        set(arg_INPUTS "${GRAZE_PRECISION_SOURCES}/inputs")
    endif()
    if(NOT DEFINED arg_FLAGS)
        set(arg_FLAGS "${GRAZE_PRECISION_FLAGS}")
    endif()
    list(LENGTH arg_FLAGS sets)
    foreach(flag IN LISTS arg_EXPECT_LOSS)
        list(JOIN arg_FLAGS " " all_sets)
        separate_arguments(all_sets UNIX_COMMAND "${all_sets}")
        if(NOT flag IN_LIST all_sets)
            message(FATAL_ERROR "${this_call}: EXPECT_LOSS ${flag}: no set of FLAGS has this flag")
        endif()
    endforeach()
    graze_precision_suite_library()

    set(common)
    foreach(option IN ITEMS PAIRS SEED THREADS TOLERANCE)
        if(arg_${option})
            string(TOLOWER "${option}" word)
            list(APPEND common --${word} ${arg_${option}})
        endif()
    endforeach()
    get_filename_component(accepted "${arg_ACCEPTED}" ABSOLUTE)
    list(APPEND common --accepted "${accepted}")
    if(arg_AS)
        list(APPEND common --as "${arg_AS}")
    endif()
    foreach(path IN LISTS arg_INPUTS)
        get_filename_component(path "${path}" ABSOLUTE)
        list(APPEND common --kept "${path}")
    endforeach()
    set(own_exclude)
    if(arg_EXCLUDE_FROM_ALL)
        set(own_exclude EXCLUDE_FROM_ALL)
    endif()

    set(number 0)
    set(tests)
    set(results)
    set(updates) # the test whose figures are accepted; the others' would write over them
    foreach(flags IN LISTS arg_FLAGS)
        math(EXPR number "${number} + 1")
        set(this "${name}")
        if(sets GREATER 1)
            set(this "${name}.${number}")
        endif()
        string(STRIP "${flags}" flags)
        set(folder "${CMAKE_CURRENT_BINARY_DIR}/${this}.files")
        string(TOUPPER "${CMAKE_BUILD_TYPE}" configuration)
        set(all_flags ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${configuration}} ${flags})
        list(JOIN all_flags " " all_flags)
        set(compiler "${CMAKE_CXX_COMPILER_ID} ${CMAKE_CXX_COMPILER_VERSION}")
        graze_precision_sources("${folder}" run.hpp
            "precision::run(argc, argv, list, \"${compiler}\", R\"flags(${all_flags})flags\")" sources)
        add_executable(${this} ${own_exclude} ${sources})
        target_link_libraries(${this} PRIVATE graze::graze ${arg_LIBRARIES} graze_precision_suite)
        if(TARGET graze_warnings)
            target_link_libraries(${this} PRIVATE graze_warnings)
        endif()
        separate_arguments(options UNIX_COMMAND "${flags}")
        list(REMOVE_AT sources 0)
        set_property(SOURCE ${sources} APPEND PROPERTY COMPILE_OPTIONS ${options})
        target_compile_definitions(${this} PRIVATE ${arg_DEFINITIONS})
        set(run ${this} ${common} --results "${folder}/results")
        if("EXPECT_LOSS" IN_LIST arg_KEYWORDS_MISSING_VALUES)
            list(APPEND run --expect-loss)
        endif()
        foreach(flag IN LISTS arg_EXPECT_LOSS)
            if(flag IN_LIST options)
                list(APPEND run --expect-loss)
            endif()
        endforeach()
        if(updates)
            list(APPEND run --no-update)
        endif()
        add_test(NAME ${this} COMMAND ${run})
        if(updates)
            set_tests_properties(${this} PROPERTIES DEPENDS ${updates})
        elseif(NOT "--expect-loss" IN_LIST run)
            set(updates ${this})
        endif()
        if(arg_EXCLUDE_FROM_ALL)
            add_test(NAME ${this}.build
                COMMAND "${CMAKE_COMMAND}" --build "${CMAKE_BINARY_DIR}" --config $<CONFIG> --target ${this})
            set_tests_properties(${this}.build PROPERTIES FIXTURES_SETUP ${this}.built
                RESOURCE_LOCK graze.build) # one build of a tree at a time
            set_tests_properties(${this} PROPERTIES FIXTURES_REQUIRED ${this}.built)
            list(APPEND tests ${this}.build)
        endif()
        list(APPEND tests ${this})
        list(APPEND results "${folder}/results/results.txt")
    endforeach()
    if(sets GREATER 1)
        add_test(NAME ${name}.flags COMMAND ${name}.1 --which-flag ${results})
        set_tests_properties(${name}.flags PROPERTIES DEPENDS "${tests}")
        if(arg_EXPECT_LOSS)
            list(JOIN arg_EXPECT_LOSS "|" guilty)
            string(REGEX REPLACE "([+.*()^?$])" "\\\\\\1" guilty "${guilty}")
            set_tests_properties(${name}.flags PROPERTIES PASS_REGULAR_EXPRESSION "lost by (${guilty})[ :]")
        endif()
        list(APPEND tests ${name}.flags)
    endif()
    if(arg_LABELS)
        set_tests_properties(${tests} PROPERTIES LABELS "${arg_LABELS}")
    endif()
endfunction()

function(graze_add_hard_case_search name)
    cmake_parse_arguments(PARSE_ARGV 1 arg "DECISIONS;EXCLUDE_FROM_ALL" ""
        "TYPES;HEADERS;FORMULAS;FLAGS;LIBRARIES;DEFINITIONS")
    graze_precision_check_words("graze_add_hard_case_search(${name})" "${arg_UNPARSED_ARGUMENTS}"
        "${arg_KEYWORDS_MISSING_VALUES}")
    if(NOT DEFINED arg_FLAGS)
        set(arg_FLAGS "${GRAZE_PRECISION_FLAGS}")
    endif()
    list(LENGTH arg_FLAGS sets)
    if(sets GREATER 1)
        message(FATAL_ERROR "graze_add_hard_case_search(${name}): FLAGS takes one string, such as \"-O2 -ffast-math\", "
            "not ${sets}")
    endif()
    graze_hard_case_search_libraries()
    if(NOT TARGET graze_precision_search_program)
        message(FATAL_ERROR "graze_add_hard_case_search: CLI11 is not found; "
            "on Debian and Ubuntu it is the package libcli11-dev")
    endif()
    graze_precision_sources("${CMAKE_CURRENT_BINARY_DIR}/${name}.files" search/program.hpp
        "search::run(argc, argv, list, \"${name}\")" sources)
    set(exclude)
    if(arg_EXCLUDE_FROM_ALL)
        set(exclude EXCLUDE_FROM_ALL)
    endif()
    add_executable(${name} ${exclude} ${sources})
    target_link_libraries(${name} PRIVATE graze::graze ${arg_LIBRARIES} graze_precision_search_program)
    if(TARGET graze_warnings)
        target_link_libraries(${name} PRIVATE graze_warnings)
    endif()
    target_compile_definitions(${name} PRIVATE ${arg_DEFINITIONS})
    separate_arguments(options UNIX_COMMAND "${arg_FLAGS}")
    list(REMOVE_AT sources 0)
    # Not in the main program, nor in the counting code, which would count itself.
    set_property(SOURCE ${sources} APPEND PROPERTY COMPILE_OPTIONS ${options} -fsanitize-coverage=trace-pc)
endfunction()
