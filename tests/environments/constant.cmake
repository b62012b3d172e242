# cmake -D COMPILER=... -D FLAGS=... -D LEVEL=0|1 -D ROOT=source-tree -P constant.cmake: decisions in constant
# expressions compile under these flags; bad input does not, for the right reason.
cmake_policy(VERSION 3.25)
separate_arguments(FLAGS)
find_program(compiler_found "${COMPILER}" NO_CACHE)
if(NOT compiler_found)
    message("SKIPPED: ${COMPILER} is not installed")
    return()
endif()
set(compile "${COMPILER}" -std=c++20 -fsyntax-only ${FLAGS} "-DGRAZE_ENVIRONMENT_LEVEL=${LEVEL}" "-I${ROOT}/include")
set(source "${ROOT}/tests/environments/constant.cpp")

execute_process(COMMAND ${compile} "${source}" COMMAND_ERROR_IS_FATAL ANY)

set(reasons
    "velocity is not finite"
    "velocity is not finite"
    "radius is negative"
    "normal is zero"
    "edge is zero"
    "edges are parallel")
execute_process(COMMAND ${compile} -DREJECTED "${source}" RESULT_VARIABLE failed ERROR_VARIABLE said)
string(REGEX MATCHALL "error: [^\n]*" errors "${said}")
list(LENGTH errors errors)
list(LENGTH reasons cases)
list(JOIN reasons ".*" in_this_order)
if(NOT failed OR NOT errors EQUAL cases OR NOT said MATCHES "reject" OR NOT said MATCHES "${in_this_order}")
    message(SEND_ERROR "${errors} errors, where ${cases} cases should not compile because of ${reasons}: ${said}")
endif()
# Without the faults, the same input compiles.
execute_process(COMMAND ${compile} -DREJECTED -DREPAIRED "${source}" COMMAND_ERROR_IS_FATAL ANY)
