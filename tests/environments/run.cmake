# cmake -D NAME=... -D COMPILER=... -D FLAGS=... -D EVENTS=... -D HASH=... -D WORK=directory -D ROOT=source-tree
#   [-D EMULATOR=...] -P run.cmake
# The fluid of examples/runs in one environment: no event is missed or invented, and its final state has this hash.
cmake_policy(VERSION 3.25)
separate_arguments(FLAGS)
separate_arguments(EMULATOR)
file(MAKE_DIRECTORY "${WORK}")
find_program(compiler_found "${COMPILER}" NO_CACHE)
if(NOT compiler_found)
    message("SKIPPED: ${COMPILER} is not installed")
    return()
endif()
set(probe "${WORK}/${NAME}.probe")
file(WRITE "${probe}.cpp" "#include <string>\nint main(int, char** words) { return std::string(words[0]).empty(); }\n")
execute_process(COMMAND "${COMPILER}" -std=c++20 ${FLAGS} "${probe}.cpp" -o "${probe}"
    RESULT_VARIABLE failed ERROR_VARIABLE said OUTPUT_QUIET)
if(NOT failed)
    execute_process(COMMAND ${EMULATOR} "${probe}" RESULT_VARIABLE failed ERROR_VARIABLE said OUTPUT_QUIET)
endif()
if(failed)
    message("SKIPPED: no program runs here that is built by ${COMPILER} ${FLAGS} ${EMULATOR}: ${failed} ${said}")
    return()
endif()

set(program "${WORK}/${NAME}.fluid")
set(runs "${ROOT}/examples/runs")
execute_process(COMMAND "${COMPILER}" -std=c++20 ${FLAGS} "-I${ROOT}/include" "${runs}/hard_sphere_fluid.cpp"
    "${runs}/exact_runs_space.cpp" -o "${program}" COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
execute_process(COMMAND ${EMULATOR} "${program}" "${EVENTS}" 0 RESULT_VARIABLE result OUTPUT_VARIABLE printed
    ERROR_VARIABLE printed)
message("${printed}")
if(NOT result EQUAL 0 OR NOT printed MATCHES "${EVENTS} events, none missed, none invented, hash ${HASH}\n")
    message(FATAL_ERROR "${NAME} ended with ${result}, and not with hash ${HASH}")
endif()
