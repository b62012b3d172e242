# cmake -D MODULE=graze.wasm -D OUT=index.html -P build.cmake: the page as one file, which needs no server. Its modules are
# data: addresses in an import map; the scenes' texts are one of them, and graze, gzipped and in base 64, another.
cmake_policy(VERSION 3.25)
set(here "${CMAKE_CURRENT_LIST_DIR}")
cmake_path(SET root NORMALIZE "${here}/../..")

set(imports "")
# add_module(name text): an import of the map, in which modules call each other by name.
function(add_module name text)
    string(REPLACE "from './" "from 'playground/" text "${text}")
    foreach(character code IN ZIP_LISTS special codes)
        string(REPLACE "${character}" "${code}" text "${text}")
    endforeach()
    string(REPLACE "\n" "%0A" text "${text}")
    string(REPLACE "\\" "%5C" text "${text}")
    set(imports "${imports},\n\"playground/${name}\": \"data:text/javascript;charset=utf-8,${text}\"" PARENT_SCOPE)
endfunction()
set(special % "\"" "#" "<")
set(codes %25 %22 %23 %3C)

file(GLOB modules "${here}/*.mjs")
foreach(module IN LISTS modules)
    file(READ "${module}" text)
    cmake_path(GET module FILENAME name)
    add_module("${name}" "${text}")
endforeach()

set(texts "")
foreach(scene IN ITEMS docs/playground/scenes/grazing_pair docs/playground/scenes/corner_pocket examples/scenes/pool_break
        examples/scenes/galperin examples/scenes/sinai)
    file(READ "${root}/${scene}.json" text)
    cmake_path(GET scene FILENAME name)
    string(APPEND texts "${name}: String.raw`${text}`,\n")
endforeach()
add_module(scene_texts.mjs "export const texts = {\n${texts}};\n")

execute_process(COMMAND gzip -9nc "${MODULE}" COMMAND base64 -w0 OUTPUT_VARIABLE module COMMAND_ERROR_IS_FATAL ANY)
add_module(graze_module.mjs "export const module = '${module}';\n")

file(READ "${here}/index.html" page)
file(READ "${here}/style.css" style)
string(REPLACE "<link rel=\"stylesheet\" href=\"style.css\">" "<style>\n${style}</style>" page "${page}")
string(SUBSTRING "${imports}" 1 -1 imports)
string(REPLACE "<script type=\"module\">" "<script type=\"importmap\">{\"imports\": {${imports}\n}}</script>\n<script type=\"module\">"
    page "${page}")
string(REPLACE "from './" "from 'playground/" page "${page}")
file(WRITE "${OUT}" "${page}")
