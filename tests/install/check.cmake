# cmake -D WAY=install|find_package|pkg-config|add_subdirectory|compiled|precision -D BUILD=... -D SOURCE=... -D WORK=... -D COMPILER=...
#       -P check.cmake
# One way for a user to get at graze, tried from nothing. The tree is moved after the installation, so that whatever
# names its old place fails.
set(prefix "${WORK}/prefix")
set(consumer "${CMAKE_CURRENT_LIST_DIR}/consumer")

function(run)
    execute_process(COMMAND ${ARGV} COMMAND_ECHO STDOUT COMMAND_ERROR_IS_FATAL ANY)
endfunction()

function(build_consumer)
    file(REMOVE_RECURSE "${WORK}/${WAY}")
    run("${CMAKE_CTEST_COMMAND}" --build-and-test "${consumer}" "${WORK}/${WAY}" --build-generator "${GENERATOR}"
        --build-options "-DCMAKE_CXX_COMPILER=${COMPILER}" ${ARGV} --test-command "${CMAKE_CTEST_COMMAND}"
        --output-on-failure --no-tests=error)
endfunction()

if(WAY STREQUAL "install")
    file(REMOVE_RECURSE "${WORK}")
    run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${WORK}/before")
    file(RENAME "${WORK}/before" "${prefix}")
elseif(WAY STREQUAL "find_package")
    build_consumer("-DCMAKE_PREFIX_PATH=${prefix}")
elseif(WAY STREQUAL "compiled")
    file(GLOB_RECURSE library "${prefix}/*graze-compiled.pc")
    if(NOT library)
        message("graze::compiled is not installed in this build (GRAZE_INSTALL_COMPILED)")
        return()
    endif()
    build_consumer("-DCMAKE_PREFIX_PATH=${prefix}" -DCOMPONENT=compiled)
    cmake_path(GET library PARENT_PATH directory)
    set(ENV{PKG_CONFIG_PATH} "${prefix}/share/pkgconfig:${directory}")
    execute_process(COMMAND pkg-config --cflags --libs --static graze-compiled OUTPUT_VARIABLE flags
        OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(flags UNIX_COMMAND "${flags}")
    run("${COMPILER}" -std=c++20 "${consumer}/main.cpp" ${flags} -o "${WORK}/by_pkg_config_compiled")
    run("${WORK}/by_pkg_config_compiled")
elseif(WAY STREQUAL "precision")
    set(consumer "${CMAKE_CURRENT_LIST_DIR}/precision")
    build_consumer("-DCMAKE_PREFIX_PATH=${prefix}")
elseif(WAY STREQUAL "add_subdirectory")
    build_consumer("-DGRAZE_SOURCE=${SOURCE}")
elseif(WAY STREQUAL "pkg-config")
    set(ENV{PKG_CONFIG_PATH} "${prefix}/share/pkgconfig")
    execute_process(COMMAND pkg-config --cflags graze OUTPUT_VARIABLE flags
        OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
    separate_arguments(flags UNIX_COMMAND "${flags}")
    run("${COMPILER}" -std=c++20 ${flags} "${consumer}/main.cpp" -o "${WORK}/by_pkg_config")
    run("${WORK}/by_pkg_config")
else()
    message(FATAL_ERROR "no such way: '${WAY}'")
endif()
