# Instructions for each event, by callgrind: the difference between two runs of different length.
#   cmake -D PROGRAM=graze-run-count -P count_run.cmake
function(count packing mechanics space events result)
    execute_process(COMMAND valgrind --tool=callgrind --callgrind-out-file=/dev/null ${PROGRAM} ${packing} ${events} ${mechanics} ${space}
        ERROR_VARIABLE told OUTPUT_QUIET COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCH "Collected : ([0-9]+)" found "${told}")
    set(${result} ${CMAKE_MATCH_1} PARENT_SCOPE)
endfunction()
foreach(mechanics exact plain)
    foreach(space planes periodic)
        foreach(packing 0.30 0.49)
            count(${packing} ${mechanics} ${space} 1000 few)
            count(${packing} ${mechanics} ${space} 6000 many)
            math(EXPR each "(${many} - ${few}) / 5000")
            message("packing ${packing}, ${mechanics}, ${space}: ${each} instructions an event")
        endforeach()
    endforeach()
endforeach()
