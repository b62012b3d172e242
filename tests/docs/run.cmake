# cmake -D PROGRAM=... -D ARGUMENT=... -D EXPECTED=file-or-nothing -P run.cmake: the program must succeed and print the
# expected text.
execute_process(COMMAND "${PROGRAM}" "${ARGUMENT}" OUTPUT_VARIABLE printed RESULT_VARIABLE result)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "ended with ${result} after printing:\n${printed}")
endif()
if(EXPECTED)
    file(READ "${EXPECTED}" expected)
    if(NOT printed STREQUAL expected)
        message(FATAL_ERROR "printed:\n${printed}\nbut the page says:\n${expected}")
    endif()
endif()
