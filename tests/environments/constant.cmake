# cmake -D COMPILER=... -D FLAGS=... -D LEVEL=0|1 -D ROOT=source-tree -P constant.cmake: decisions in constant
# expressions compile under these flags, and bad input does not, for its own reason.
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
set(case 0)
foreach(reason IN LISTS reasons)
    math(EXPR case "${case} + 1")
    execute_process(COMMAND ${compile} -DREJECTED=${case} "${source}" RESULT_VARIABLE failed ERROR_VARIABLE said)
    if(NOT failed)
        message(SEND_ERROR "case ${case} compiles although ${reason}")
    elseif(NOT said MATCHES "reject" OR NOT said MATCHES "${reason}")
        message(SEND_ERROR "case ${case} does not compile, but not because ${reason}: ${said}")
    endif()
endforeach()
# The same input without the fault compiles.
execute_process(COMMAND ${compile} -DREJECTED=0 "${source}" COMMAND_ERROR_IS_FATAL ANY)
