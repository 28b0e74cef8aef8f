# What every target of the project is compiled with.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)

if(PROJECT_IS_TOP_LEVEL)
    set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
    find_program(FUMAGE_CCACHE ccache)
    if(FUMAGE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
        # What one checkout has compiled serves every other one; and what comes from a precompiled header may be kept.
        set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env
            CCACHE_BASEDIR=${CMAKE_SOURCE_DIR} CCACHE_NOHASHDIR=1 CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime ${FUMAGE_CCACHE})
    endif()
endif()

# Apple's libc++ has no stop tokens, or has them in its experimental part; ours serve the core and the command line there.
include(CheckCXXSourceCompiles)
set(FUMAGE_STOP_TOKEN_SOURCE "#include <stop_token>\n#include <thread>\nint main() { std::jthread thread([](std::stop_token) {}); return 0; }")
block()
    set(CMAKE_REQUIRED_FLAGS "-std=c++20 -pthread")
    if(MSVC)
        set(CMAKE_REQUIRED_FLAGS "/std:c++20")
    endif()
    check_cxx_source_compiles("${FUMAGE_STOP_TOKEN_SOURCE}" FUMAGE_HAS_STOP_TOKEN)
    if(NOT FUMAGE_HAS_STOP_TOKEN)
        string(APPEND CMAKE_REQUIRED_FLAGS " -fexperimental-library")
        check_cxx_source_compiles("${FUMAGE_STOP_TOKEN_SOURCE}" FUMAGE_HAS_EXPERIMENTAL_STOP_TOKEN)
    endif()
endblock()
if(FUMAGE_HAS_EXPERIMENTAL_STOP_TOKEN)
    add_compile_options(-fexperimental-library)
    add_link_options(-fexperimental-library)
elseif(NOT FUMAGE_HAS_STOP_TOKEN)
    include_directories(SYSTEM ${CMAKE_CURRENT_LIST_DIR}/fallbacks)
endif()

# fumage_precompile(<target> <headers>...): headers from outside the project, which most of a target's files read. Files include what they use all the
# same: lint reads each of them alone.
function(fumage_precompile target)
    target_precompile_headers(${target} PRIVATE ${ARGN})
    fumage_precompiled_options(${target})
endfunction()

# What ccache asks for, so that it knows what is in a precompiled header.
function(fumage_precompiled_options target)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        target_compile_options(${target} PRIVATE -fpch-preprocess)
    elseif(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
        target_compile_options(${target} PRIVATE "SHELL:-Xclang -fno-pch-timestamp")
    endif()
endfunction()

# fumage_compile_options(<target>): code of this project, tests and benchmarks too. Warnings are errors where
# CMAKE_COMPILE_WARNING_AS_ERROR says so, which the presets do: never for somebody who only builds it.
function(fumage_compile_options target)
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR}/generated)
    # No fused multiply-add and no fast-math: the same bits on every machine are a promise of the library.
    if(MSVC)
        # clang-cl; Microsoft's own compiler has no vectors as types.
        target_compile_options(${target} PRIVATE /fp:precise /clang:-ffp-contract=off /EHsc /bigobj /W3)
        return()
    endif()
    target_compile_options(${target} PRIVATE -ffp-contract=off -fno-math-errno -Wall -Wextra -Wconversion -Wshadow -Wpedantic)
    if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
        # GCC 12 reports members of std::variant and std::optional, and copies in std::string, that it cannot follow.
        target_compile_options(${target} PRIVATE -Wno-maybe-uninitialized -Wno-restrict -Wno-missing-field-initializers)
    endif()
endfunction()

# fumage_without_other_systems(<list>): what systems do in different ways stands in files called so, one for each.
function(fumage_without_other_systems list)
    if(WIN32)
        list(FILTER ${list} EXCLUDE REGEX "_posix\\.cpp$")
    else()
        list(FILTER ${list} EXCLUDE REGEX "_windows\\.cpp$")
    endif()
    set(${list} ${${list}} PARENT_SCOPE)
endfunction()

# fumage_sources(<target>): every source and header below the current folder; a new file needs no line here.
function(fumage_sources target)
    file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
    fumage_without_other_systems(sources)
    target_sources(${target} PRIVATE ${sources})
endfunction()

# fumage_windows_program(<target> [<what it is> [<icon as SVG>]]): says to Windows that the program's texts are UTF-8, its paths may be long and its windows
# know of pixels, which version it is, and how it looks.
set(FUMAGE_WINDOWS_FOLDER ${CMAKE_CURRENT_LIST_DIR}/windows)
function(fumage_windows_program target)
    set(FUMAGE_MANIFEST ${FUMAGE_WINDOWS_FOLDER}/program.manifest)
    set(FUMAGE_DESCRIPTION "${ARGV1}")
    if(MINGW)
        enable_language(RC)
        set(FUMAGE_ICON_LINE "")
        if(ARGC GREATER 2)
            fumage_windows_icon(${target} ${ARGV2})
        endif()
        configure_file(${FUMAGE_WINDOWS_FOLDER}/program.rc.in ${CMAKE_CURRENT_BINARY_DIR}/${target}.rc @ONLY)
        target_sources(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/${target}.rc)
        set_source_files_properties(${CMAKE_CURRENT_BINARY_DIR}/${target}.rc PROPERTIES OBJECT_DEPENDS "${FUMAGE_MANIFEST};${FUMAGE_ICON}")
    elseif(WIN32)
        target_sources(${target} PRIVATE ${FUMAGE_MANIFEST})
    endif()
endfunction()

# Draws the icon in the sizes that Windows shows (needs rsvg-convert and Python's PIL).
function(fumage_windows_icon target svg)
    find_program(RSVG_CONVERT rsvg-convert)
    if(NOT RSVG_CONVERT)
        message(NOTICE "Without rsvg-convert ${target}.exe will have no icon.")
        return()
    endif()
    set(icon ${CMAKE_CURRENT_BINARY_DIR}/${target}.ico)
    set(pictures "")
    set(commands "")
    foreach(size 16 20 24 32 40 48 64 96 128 256)
        set(picture ${CMAKE_CURRENT_BINARY_DIR}/${target}-${size}.png)
        list(APPEND pictures ${picture})
        list(APPEND commands COMMAND ${RSVG_CONVERT} --width ${size} --height ${size} --output ${picture} ${svg})
    endforeach()
    add_custom_command(OUTPUT ${icon} ${commands} COMMAND /usr/bin/python3 ${FUMAGE_WINDOWS_FOLDER}/icon.py ${icon} ${pictures}
        DEPENDS ${svg} ${FUMAGE_WINDOWS_FOLDER}/icon.py COMMENT "Drawing the icon of ${target}" VERBATIM)
    target_sources(${target} PRIVATE ${icon})
    set(FUMAGE_ICON ${icon} PARENT_SCOPE)
    set(FUMAGE_ICON_LINE "1 ICON \"${icon}\"" PARENT_SCOPE)
endfunction()
