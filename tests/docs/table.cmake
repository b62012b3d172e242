# cmake -D ROOT=... -D PROGRAM=graze-compare -P table.cmake: the table in the first tutorial is what its command prints,
# except for the times.
cmake_policy(VERSION 3.25)
file(READ "${ROOT}/docs/tutorial/first-comparison.md" page)
execute_process(COMMAND "${PROGRAM}" --types double --timing 0.02 OUTPUT_VARIABLE printed COMMAND_ERROR_IS_FATAL ANY)

# The method, then wrong, worst, CR and time, three times.
set(cells " +([^ \n]+) +([^ \n]+) +([^ \n]+) +[0-9.]+ [^ \n]*s[*]?")
foreach(text IN ITEMS page printed)
    string(REGEX MATCHALL "[a-z]+/[a-z]+${cells}${cells}${cells} *\n" ${text}_rows "${${text}}")
    list(TRANSFORM ${text}_rows REPLACE "([a-z]+/[a-z]+)${cells}" "\\1 \\2 \\3 \\4 |")
    list(TRANSFORM ${text}_rows REPLACE "\\|${cells}${cells} *\n" "| \\1 \\2 \\3 | \\4 \\5 \\6")
endforeach()
list(LENGTH page_rows count)
if(count LESS 5)
    message(FATAL_ERROR "only ${count} rows were found")
endif()
if(NOT page_rows STREQUAL printed_rows)
    message(FATAL_ERROR "the page says\n${page_rows}\nbut it is\n${printed_rows}")
endif()
