# SPDX-License-Identifier: GPL-3.0-or-later
# ANNULUS_UNITY: which files are compiled together. Parsing the headers of the standard library, of CGAL, CLI11 and JSON costs most files
# more than what is in them. The names in unnamed namespaces of a group differ; a file with names of its own stays alone, as do files
# with flags of their own (CMake keeps those apart).

# The sources of `target` that match PATTERN become one piece, GROUP.
function(annulus_unite target group pattern)
    if(NOT ANNULUS_UNITY)
        return()
    endif()
    get_target_property(sources ${target} SOURCES)
    list(FILTER sources INCLUDE REGEX "${pattern}")
    set_source_files_properties(${sources} PROPERTIES UNITY_GROUP ${group})
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
    # g++ takes an unnamed namespace of an included file for one that several files see; g++ 12 has false warnings about the copying of
    # strings where much is inlined.
    target_compile_options(${target} PRIVATE "$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage;-Wno-restrict>")
endfunction()

annulus_unite(annulus cgal "/(moving_delaunay_[23]|mesh_embedding)[.]cpp$")
if(ANNULUS_BUILD_TOOLKIT)
    annulus_unite(annulus-toolkit readers "/formats/read_[a-z_]*[.]cpp$")
    annulus_unite(annulus-toolkit formats "/formats/[^r][a-z_]*[.]cpp$")
    annulus_unite(annulus-toolkit report "/report/[a-z_]*[.]cpp$")
    annulus_unite(annulus-toolkit reproduction "/reproduction/[a-z_]*[.]cpp$")
    annulus_unite(annulus-toolkit motion "/motion/[a-z_0-9]*[.]cpp$")
    annulus_unite(annulus-toolkit plane "/motion/(domain_2|sampling_2)[.]cpp$")
    annulus_unite(annulus-toolkit surfaces "/motion/(surface_3|[a-z]*_faults)[.]cpp$")
    # CGAL's Mesh_3 takes a minute by itself; the others have names that others of their room have, too.
    foreach(alone IN ITEMS motion/initial_mesh_3 motion/nodt_3 motion/kept_cells_3 motion/stars_2 formats/read_csv
            formats/write_frames formats/text_input formats/xyz_guess)
        set_source_files_properties(src/annulus/${alone}.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
    endforeach()
endif()
