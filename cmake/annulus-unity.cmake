# SPDX-License-Identifier: GPL-3.0-or-later
# ANNULUS_UNITY: which files are compiled together. For most files parsing the headers of the standard library, CGAL,
# CLI11 and JSON takes longer than their own code. The names in unnamed namespaces of a group differ; a file whose names
# clash is compiled alone, as are files with special flags (CMake separates those).

# The sources of `target` that match PATTERN become one piece, GROUP.
function(annulus_unite target group pattern)
    if(NOT ANNULUS_UNITY)
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "${pattern}")
    set_source_files_properties(${sources} PROPERTIES UNITY_GROUP ${group})
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # g++ warns of an unnamed namespace in an included file as if it were a header; g++ 12 has false warnings about the
    # copying of strings where much is inlined.
    target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage;-Wno-restrict>")
endfunction()

annulus_unite(annulus-view cgal "/moving_delaunay_[23][.]cpp$")
if(ANNULUS_BUILD_APPS AND NOT ANNULUS_CORE_ONLY)
    annulus_unite(annulus-apps-objects readers "/formats/read_[a-z_]*[.]cpp$")
    annulus_unite(annulus-apps-objects formats "/formats/[^r][a-z_]*[.]cpp$")
    annulus_unite(annulus-apps-objects report "/report/[a-z_]*[.]cpp$")
    annulus_unite(annulus-apps-objects motion "/motion/[a-z_0-9]*[.]cpp$")
    annulus_unite(annulus-apps-objects plane "/motion/(domain_2|sampling_2)[.]cpp$")
    annulus_unite(annulus-apps-objects polygons "/motion/(polygon_rings_2|triangles_2)[.]cpp$")
    annulus_unite(annulus-solids solids "/(motion|formats)/[a-z_0-9]*[.]cpp$")
    annulus_unite(annulus-solids surfaces "/motion/(surface_3|[a-z]*_faults)[.]cpp$")
    # CGAL's Mesh_3 takes a minute alone; the others, or Netpbm's headers, have names that occur elsewhere in a module.
    foreach(alone IN ITEMS motion/initial_mesh_3 motion/nodt_3 motion/kept_cells_3 motion/stars_2 formats/read_csv
            formats/read_pnm formats/write_frames formats/text_input formats/xyz_guess)
        set_source_files_properties(src/apps/${alone}.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endforeach()
endif()

# The modules of the core in so many pieces, which halves their compile time. Files that instantiate the same class are
# in different pieces. The instructions that run are the same (bench/instructions), since a large piece is inlined as
# much as a file is: by default g++ lets large ones grow by 40 %, and a construction in 3D would take 8 % more.
function(annulus_unite_core target)
    if(NOT ANNULUS_UNITY)
        return()
    endif()
    foreach(pieces IN ITEMS space=1 mesh=1 kernel=2 engine=4 published=2 measure=4)
        string(REPLACE "=" ";" pieces "${pieces}")
        list(POP_FRONT pieces module)
        math(EXPR last "${pieces} - 1")
        foreach(piece RANGE ${last})
            set(files_${piece} "")
            set(classes_${piece} "")
        endforeach()
        get_target_property(sources ${target} SOURCES)
        list(FILTER sources INCLUDE REGEX "/annulus/${module}/[a-z_0-9]*[.]cpp$")
        # Their names clash with others.
        list(FILTER sources EXCLUDE REGEX "/(table_measures|clear_(periodic_)?cells)[.]cpp$")
        list(FILTER sources EXCLUDE REGEX "/(reach|voronoi_(kept|facets|neighbour_counts))[.]cpp$")
        foreach(source IN LISTS sources)
            file(STRINGS "${source}" classes REGEX "^template class ")
            set(best "")
            set(least 1000)
            foreach(piece RANGE ${last})
                set(shared ${classes})
                list(REMOVE_ITEM shared ${classes_${piece}} "")
                list(LENGTH classes all)
                list(LENGTH shared others)
                list(LENGTH files_${piece} count)
                if(others EQUAL all AND count LESS least)
                    set(best ${piece})
                    set(least ${count})
                endif()
            endforeach()
            if(NOT best STREQUAL "")
                list(APPEND files_${best} "${source}")
                list(APPEND classes_${best} ${classes})
            endif()
        endforeach()
        foreach(piece RANGE ${last})
            set_source_files_properties(${files_${piece}} PROPERTIES UNITY_GROUP ${module}_${piece})
        endforeach()
    endforeach()
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    target_compile_options(${target} PRIVATE
                           "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage;--param=large-unit-insns=10000000>")
endfunction()
annulus_unite_core(annulus-core-objects)

# ANNULUS_PRECOMPILE: headers of the standard library and of Boost, two fifths of the compile time of the core, are
# parsed once. g++ suppresses warnings about system headers, but not once they are precompiled.
set(annulus_quiet_about_precompiled
    "$<$<CXX_COMPILER_ID:GNU>:-Wno-array-bounds;-Wno-stringop-overflow;-Wno-stringop-overread;\
-Wno-maybe-uninitialized>")
if(ANNULUS_PRECOMPILE)
    foreach(target IN ITEMS annulus-core-objects annulus-arithmetic)
        target_compile_options(${target} PRIVATE ${annulus_quiet_about_precompiled}
                               "$<$<CXX_COMPILER_ID:Clang>:SHELL:-Xclang -fno-pch-timestamp>")  # for ccache
    endforeach()
    target_precompile_headers(annulus-core-objects PRIVATE
        <algorithm> <array> <atomic> <bit> <cmath> <functional> <limits> <memory> <optional> <random> <span>
        <string> <thread> <unordered_map> <vector> <boost/container/small_vector.hpp>
        <boost/container/static_vector.hpp> <boost/numeric/interval.hpp> <gmpxx.h>
        <oneapi/tbb/parallel_for.h> <oneapi/tbb/parallel_pipeline.h> <oneapi/tbb/task_arena.h>)
    target_precompile_headers(annulus-arithmetic REUSE_FROM annulus-core-objects)
    # Flags of their own
    set_source_files_properties(${annulus_cool_sources} src/annulus/engine/sign_evaluator.cpp
                                PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endif()

# Tests: the files of LIST become pieces of at most SIZE files of one folder, for a build that compiles all of them
# anyway: their includes are parsed once per piece, and templates are instantiated once. Two files may have the same
# names, so each file is in its own namespace, after all includes of the piece. A file that opens a namespace which
# others use, has conditional includes or has no test is compiled alone.
function(annulus_unite_tests list size)
    if(NOT ANNULUS_UNITY)
        return()
    endif()
    set(result "")
    set(folders "")
    foreach(source IN LISTS ${list})
        get_source_file_property(definitions "${source}" COMPILE_DEFINITIONS)
        file(READ "${source}" text)
        if(definitions OR NOT text MATCHES "\n(TEMPLATE_)?TEST_CASE" OR text MATCHES "\nnamespace [a-zA-Z]|\n#if")
            list(APPEND result "${source}")
            continue()
        endif()
        set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${source}")
        cmake_path(GET source PARENT_PATH folder)
        cmake_path(GET folder FILENAME folder)
        list(APPEND folders "${folder}")
        list(APPEND "of_${folder}" "${source}")
    endforeach()
    list(REMOVE_DUPLICATES folders)
    foreach(folder IN LISTS folders)
        list(LENGTH "of_${folder}" count)
        math(EXPR pieces "(${count} + ${size} - 1) / ${size}")
        math(EXPR each "(${count} + ${pieces} - 1) / ${pieces}")
        set(first 0)
        while(first LESS count)
            list(SUBLIST "of_${folder}" ${first} ${each} members)
            set(piece "${CMAKE_CURRENT_BINARY_DIR}/united/${list}/${folder}_${first}.cpp")
            annulus_write_piece("${piece}" "${members}")
            list(APPEND result "${piece}")
            math(EXPR first "${first} + ${each}")
        endwhile()
    endforeach()
    set(${list} "${result}" PARENT_SCOPE)
endfunction()

# The includes of all members, then each member in a namespace.
function(annulus_write_piece piece members)
    set(includes "")
    set(bodies "")
    foreach(source IN LISTS members)
        cmake_path(GET source PARENT_PATH folder)
        cmake_path(RELATIVE_PATH source BASE_DIRECTORY "${CMAKE_CURRENT_SOURCE_DIR}" OUTPUT_VARIABLE name)
        string(MAKE_C_IDENTIFIER "in_${name}" name)
        file(STRINGS "${source}" lines REGEX "^#include ")
        foreach(line IN LISTS lines)
            string(REGEX REPLACE "^#include \"(.*)\"$" "#include \"${folder}/\\1\"" line "${line}")
            list(APPEND includes "${line}")
        endforeach()
        string(APPEND bodies "namespace ${name} {\n#include \"${source}\"\n}\n")
    endforeach()
    list(REMOVE_DUPLICATES includes)
    list(JOIN includes "\n" includes)
    file(CONFIGURE OUTPUT "${piece}" CONTENT "${includes}\n${bodies}" @ONLY)
endfunction()
