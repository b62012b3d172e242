# cmake -D COMPILER=... -D OBJDUMP=... -D INCLUDE=directory -D WORK=directory -P instructions.cmake: a decision of foreign balls has
# no more instructions than one of graze's own.
cmake_policy(VERSION 3.25)
set(object "${WORK}/instructions.o")
execute_process(COMMAND "${COMPILER}" -std=c++20 -O2 -DNDEBUG -DGRAZE_COMPILED "-I${INCLUDE}" -c "${CMAKE_CURRENT_LIST_DIR}/instructions.cpp"
    -o "${object}" COMMAND_ERROR_IS_FATAL ANY)
foreach(name IN ITEMS own foreign)
    execute_process(COMMAND "${OBJDUMP}" -d --no-show-raw-insn --disassemble=${name} "${object}" OUTPUT_VARIABLE code COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "\n +[0-9a-f]+:\t[a-mo-z]" instructions "${code}") # but for nop, which aligns
    list(LENGTH instructions ${name})
endforeach()
message("own: ${own}, foreign: ${foreign}")
if(own LESS 50 OR foreign GREATER own)
    message(FATAL_ERROR "a foreign ball takes more instructions")
endif()
