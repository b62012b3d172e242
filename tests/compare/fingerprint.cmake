# Runs PROGRAM, after compiling it from SOURCE if COMPILER is given, and compares its output with the file KNOWN.
if(COMPILER)
    separate_arguments(flags UNIX_COMMAND "${FLAGS}")
    execute_process(COMMAND ${COMPILER} -std=c++20 ${flags} "-I${INCLUDE}" "${SOURCE}" -o "${PROGRAM}"
        COMMAND_ERROR_IS_FATAL ANY)
endif()
execute_process(COMMAND ${EMULATOR} "${PROGRAM}" OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)
file(READ "${KNOWN}" known)
if(NOT printed STREQUAL known)
    message(FATAL_ERROR "the families' pairs are others here:\n${printed}")
endif()
