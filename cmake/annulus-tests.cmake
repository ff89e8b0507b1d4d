# SPDX-License-Identifier: GPL-3.0-or-later
# Shared by tests, the model in fuzz/common/ and the fuzz targets: options and two precompiled headers.
find_package(Catch2 3 QUIET)
if(NOT Catch2_FOUND)
    find_package(Catch2 2.13 REQUIRED)
endif()
find_package(rapidcheck REQUIRED)

# Optimised a little: compiling takes longer than running, and most of the running time is in the library.
add_library(annulus-test-options INTERFACE)
target_compile_options(annulus-test-options INTERFACE $<$<CONFIG:Release>:-O1>
    "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")
if(ANNULUS_UNITY)  # see annulus_unite; the more g++ 12 inlines, the more such warnings it has
    target_compile_options(annulus-test-options INTERFACE
        "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage;-Wno-restrict;-Wno-array-bounds>"
        "$<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow;-Wno-maybe-uninitialized>")
endif()
target_link_libraries(annulus-test-options INTERFACE Catch2::Catch2 rapidcheck annulus_warnings)

# Precompiled headers: only those of other projects, which never change. annulus-headers has those of the test
# libraries, annulus-headers-cgal also CGAL's, which take six seconds to parse and one to load. Targets that use them
# must have the same options. ccache takes files with a precompiled header if CCACHE_SLOPPINESS has pch_defines and
# time_macros, as in the build presets, and Clang leaves out the time stamp.
set(annulus_test_headers <catch2/catch.hpp> <rapidcheck.h>)
if(Catch2_VERSION VERSION_GREATER_EQUAL 3)  # as tests/support/catch.h chooses
    set(annulus_test_headers <catch2/catch_all.hpp> <rapidcheck.h>)
endif()
set(annulus_cgal_headers
    <boost/numeric/interval.hpp> <gmpxx.h>
    <CGAL/Exact_predicates_inexact_constructions_kernel.h> <CGAL/Delaunay_triangulation_2.h>
    <CGAL/Delaunay_triangulation_3.h> <CGAL/Triangulation_vertex_base_with_info_2.h>
    <CGAL/Triangulation_vertex_base_with_info_3.h> <CGAL/Delaunay_triangulation_cell_base_3.h>)
file(CONFIGURE OUTPUT nothing.cpp CONTENT "// Only its precompiled header is used.\n")
# Where fuzz targets are built, they and their model have a separate header: there test files are compiled without
# coverage counters, in three quarters of the time. (With -O0 they would take a third, and run twice as long.)
set(annulus_header_targets annulus-headers annulus-headers-cgal)
set(annulus_fuzz_headers annulus-headers-cgal)
if(ANNULUS_BUILD_FUZZ)
    set(annulus_fuzz_headers annulus-headers-fuzz)
    list(APPEND annulus_header_targets ${annulus_fuzz_headers})
    set(annulus_test_flags -fno-sanitize=fuzzer-no-link)
endif()
foreach(target IN LISTS annulus_header_targets)
    add_library(${target} OBJECT "${CMAKE_CURRENT_BINARY_DIR}/nothing.cpp")
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    target_link_libraries(${target} PRIVATE annulus::apps annulus-test-options)
    if(target STREQUAL "annulus-headers")
        target_precompile_headers(${target} PRIVATE ${annulus_test_headers})
    else()
        target_precompile_headers(${target} PRIVATE ${annulus_test_headers} ${annulus_cgal_headers})
    endif()
    if(NOT target STREQUAL "annulus-headers-fuzz")
        target_compile_options(${target} PRIVATE ${annulus_test_flags})
    endif()
endforeach()

# A target of tests, or of fuzzing. HEADERS: annulus-headers, or annulus-headers-cgal where most of its files include
# CGAL, themselves or through our headers, or annulus-headers-fuzz. LIBRARY: annulus::annulus or annulus::apps.
function(annulus_test_target target headers library)
    if(NOT headers STREQUAL "annulus-headers-fuzz")
        target_compile_options(${target} PRIVATE ${annulus_test_flags})
    endif()
    if(headers STREQUAL "annulus-headers-cgal")
        target_compile_options(${target} PRIVATE ${annulus_quiet_about_precompiled})
    endif()
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    target_include_directories(${target} PRIVATE "${PROJECT_SOURCE_DIR}/tests" "${PROJECT_SOURCE_DIR}/fuzz")
    target_link_libraries(${target} PRIVATE ${library} annulus-test-options)
    target_precompile_headers(${target} REUSE_FROM ${headers})
endfunction()

# Removes from a list the files that include libraries which this build does not have.
function(annulus_keep_what_links list)
    set(kept "")
    set(missing "no such header")
    if(ANNULUS_CORE_ONLY)
        set(missing "^#include <apps/")
    elseif(NOT ANNULUS_MESHING)
        set(missing "^#include <.*/initial_mesh_3[.]h")
    endif()
    foreach(source IN LISTS ${list})
        file(STRINGS "${source}" later LIMIT_COUNT 1 REGEX "${missing}")
        if(NOT later)
            list(APPEND kept "${source}")
        endif()
    endforeach()
    set(${list} "${kept}" PARENT_SCOPE)
endfunction()
