# Every header passes the checks of .clang-tidy: cmake -D CLANG_TIDY=program -D SOURCE=file -D ROOT=repository -P tidy.cmake
if(NOT CLANG_TIDY)
    message("clang-tidy is not found: no header was looked at")
    return()
endif()
execute_process(COMMAND "${CLANG_TIDY}" --quiet "--config-file=${ROOT}/.clang-tidy"
    "--header-filter=${ROOT}/include/graze/.*" "${SOURCE}" -- -std=c++20 "-I${ROOT}/include"
    RESULT_VARIABLE result OUTPUT_VARIABLE findings ERROR_VARIABLE errors)
if(NOT result EQUAL 0)
    message(FATAL_ERROR "${findings}${errors}")
endif()
