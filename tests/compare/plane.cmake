# cmake -D PLANE=graze-compare-plane -D PROGRAM=graze-compare -D SCENES=folder -P plane.cmake: both say the same of pairs in the
# plane, in every type, and the first one refuses pairs in space.
cmake_policy(VERSION 3.25)
set(inexact graze,float,double,cpp_bin_float_50,cpp_dec_float_50) # of exact types, as many pairs are scored as there is time for
foreach(arguments IN ITEMS "--types;${inexact}" "--family;near_contact;--count;10")
    foreach(program IN ITEMS PLANE PROGRAM)
        execute_process(COMMAND "${${program}}" --timing 0 --every-row ${arguments} OUTPUT_VARIABLE said_by_${program}
            ERROR_QUIET COMMAND_ERROR_IS_FATAL ANY)
    endforeach()
    string(LENGTH "${said_by_PLANE}" length)
    if(NOT said_by_PLANE STREQUAL said_by_PROGRAM OR length LESS 1000)
        message(FATAL_ERROR "they differ:\n${said_by_PLANE}\n${said_by_PROGRAM}")
    endif()
endforeach()
execute_process(COMMAND "${PLANE}" "${SCENES}/hard_sphere_fluid.json" --timing 0 RESULT_VARIABLE code ERROR_VARIABLE said)
if(NOT code EQUAL 2 OR NOT said MATCHES "these pairs are in space")
    message(FATAL_ERROR "it ended with ${code}: ${said}")
endif()
