# SPDX-License-Identifier: GPL-3.0-or-later
# Build type, ccache, sanitizers of the fuzz build, and the target annulus_warnings.

if(PROJECT_IS_TOP_LEVEL)
    set(CMAKE_EXPORT_COMPILE_COMMANDS ON)

    get_property(multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
    if(NOT multi_config AND NOT CMAKE_BUILD_TYPE)
        set(CMAKE_BUILD_TYPE Release CACHE STRING "Release, RelWithDebInfo or Debug" FORCE)
    endif()

    find_program(CCACHE_PROGRAM ccache)
    if(CCACHE_PROGRAM AND NOT DEFINED CMAKE_CXX_COMPILER_LAUNCHER)
        set(CMAKE_CXX_COMPILER_LAUNCHER "${CCACHE_PROGRAM}")
    endif()
endif()

include(annulus-flags)
annulus_refuse_compiler("${CMAKE_CXX_COMPILER_ID}")
annulus_refuse_all_flags()

# Everything is instrumented, including the library, so that one build serves tests and fuzzing; the fuzz targets add
# libFuzzer's main when they link.
if(ANNULUS_BUILD_FUZZ)
    if(NOT CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
        message(FATAL_ERROR "ANNULUS_BUILD_FUZZ needs clang++ for libFuzzer; the compiler is ${CMAKE_CXX_COMPILER_ID}")
    endif()
    set(annulus_sanitizers address,undefined,float-cast-overflow)
    # Not checked, which saves a sixth of the compile time: null pointers, which crash under AddressSanitizer as well,
    # and alignment, size and dynamic type of objects, which only casts can get wrong: those here are from bytes to
    # bytes.
    add_compile_options(-fsanitize=fuzzer-no-link,${annulus_sanitizers} -fno-sanitize=null,alignment,object-size,vptr
                        -fno-sanitize-recover=all -fno-omit-frame-pointer)
    add_link_options(-fsanitize=${annulus_sanitizers})
endif()

# Linked privately by the project's own targets, and empty in a parent project, which has its own warnings. Headers of
# other projects come from imported targets, which CMake treats as system headers, so they do not warn.
add_library(annulus_warnings INTERFACE)
if(PROJECT_IS_TOP_LEVEL)
    target_compile_options(annulus_warnings INTERFACE
        $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wall;-Wextra;-Wshadow;-Wconversion;-Wno-psabi>
        $<$<COMPILE_LANG_AND_ID:CXX,Clang,AppleClang>:-Wall;-Wextra;-Wconversion>
        # In files that are compiled together clang reports shadowing where a local name equals one of another file's
        # unnamed namespace.
        $<$<AND:$<COMPILE_LANG_AND_ID:CXX,Clang,AppleClang>,$<NOT:$<BOOL:$<TARGET_PROPERTY:UNITY_BUILD>>>>:-Wshadow>
        $<$<AND:$<BOOL:${ANNULUS_WERROR}>,$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>>:-Werror>)
endif()
