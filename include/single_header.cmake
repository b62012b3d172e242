# cmake -D OUT=file [-D "DOORS=classify;run;number/adapter/gmp;..."] -D VERSION=x.y.z -P single_header.cmake
# Writes graze as one header: what these headers of include/graze include, each once, in an order in which each comes after
# those that it needs; without DOORS, graze.hpp. Licence, version and list of headers stand at its head.
cmake_policy(VERSION 3.25)
cmake_path(GET CMAKE_CURRENT_LIST_DIR PARENT_PATH root)
if(NOT DOORS)
    set(DOORS graze)
endif()

set(seen "")     # headers whose text is in the body
set(standard "") # what they include of other libraries, whatever they are compiled with
set(body "")

# add(header): its text, after that of all that it includes. What it includes under a condition keeps that condition, but
# not what that needs in turn: this may be needed elsewhere without it.
macro(hoist_dependencies text)
    string(REGEX MATCHALL "\n#include <graze/[^>\n]+>" includes "\n${text}")
    foreach(include IN LISTS includes)
        string(REGEX REPLACE ".*<(.+)>" "\\1" include "${include}")
        add("${include}")
    endforeach()
endmacro()

function(add header)
    if(header IN_LIST seen)
        return()
    endif()
    list(APPEND seen "${header}")
    file(READ "${root}/include/${header}" text)

    # Conditional blocks with an include of graze's: none nests another condition, and none has an #else.
    string(REGEX MATCHALL "\n#if [^\n]+\n(#include <graze/[^>\n]+>\n)+#endif" blocks "${text}")
    set(conditional "")
    foreach(block IN LISTS blocks)
        string(REPLACE "${block}" "" text "${text}")
        string(REGEX MATCH "#if [^\n]+" condition "${block}")
        string(REGEX MATCHALL "<graze/[^>\n]+>" includes "${block}")
        foreach(include IN LISTS includes)
            string(REGEX REPLACE "<(.+)>" "\\1" include "${include}")
            if(NOT include IN_LIST seen)
                list(APPEND seen "${include}")
                file(READ "${root}/include/${include}" inner)
                hoist_dependencies("${inner}")
                string(REGEX REPLACE "(^|\n)#(pragma once|include <graze/[^>\n]+>)" "\\1" inner "${inner}")
                string(APPEND conditional "\n// ${include}\n${condition}\n${inner}#endif\n")
            endif()
        endforeach()
    endforeach()

    hoist_dependencies("${text}")
    string(REGEX REPLACE "\n#pragma once\n" "\n" text "${text}")
    string(REGEX REPLACE "\n#include <graze/[^>\n]+>" "" text "${text}")

    # The includes of a header that stand before its first condition go to the head of the file.
    string(FIND "${text}" "\n#if" end)
    if(end EQUAL -1)
        string(LENGTH "${text}" end)
    endif()
    string(SUBSTRING "${text}" 0 ${end} head)
    string(SUBSTRING "${text}" ${end} -1 rest)
    string(REGEX MATCHALL "\n#include <[^>\n]+>" includes "${head}")
    string(REGEX REPLACE "\n#include <[^>\n]+>" "" head "${head}")
    list(APPEND standard ${includes})
    set(text "${head}${rest}")

    string(REGEX REPLACE "\n\n\n+" "\n\n" text "${text}")
    string(APPEND body "\n// ${header}\n${text}${conditional}")
    foreach(variable IN ITEMS seen standard body)
        set(${variable} "${${variable}}" PARENT_SCOPE)
    endforeach()
endfunction()

foreach(door IN LISTS DOORS)
    add("graze/${door}.hpp")
endforeach()
list(TRANSFORM standard STRIP)
list(SORT standard)
list(REMOVE_DUPLICATES standard)
list(JOIN standard "\n" standard)

file(READ "${root}/LICENSE" licence)
string(STRIP "${licence}" licence)
string(REPLACE "\n" "\n// " licence "// ${licence}")
string(REPLACE "// \n" "//\n" licence "${licence}")
list(JOIN DOORS ", " doors)
file(WRITE "${OUT}" "// graze ${VERSION} as one header: ${doors}\n//\n${licence}\n#pragma once\n\n${standard}\n${body}")
