# SPDX-License-Identifier: GPL-3.0-or-later
# Four programs. `annulus` starts the three others for `annulus nodt`, `annulus sweep` and `annulus reproduce`: only
# these contain the reader of specifications, MPI and the study of the paper, and only annulus-nodt and
# annulus-reproduce contain CGAL's Mesh_3, which takes a minute to compile. So the other subcommands are built in half
# the time.
find_package(CLI11 2.1 REQUIRED)

# ---- The modules experiment, of annulus-sweep, and reproduction, of annulus-reproduce ---------------
if(ANNULUS_BUILD_STUDIES)
    find_package(tomlplusplus 3.3 REQUIRED)
    if(ANNULUS_MPI STREQUAL "AUTO")
        find_package(MPI QUIET COMPONENTS CXX)
    elseif(ANNULUS_MPI)
        find_package(MPI REQUIRED COMPONENTS CXX)
    endif()
    file(GLOB annulus_experiment_sources CONFIGURE_DEPENDS src/apps/experiment/*.cpp)
    if(ANNULUS_MPI AND MPI_CXX_FOUND)
        list(FILTER annulus_experiment_sources EXCLUDE REGEX "/ranks_alone.cpp$")
    else()
        list(FILTER annulus_experiment_sources EXCLUDE REGEX "/ranks_mpi.cpp$")
    endif()
    add_library(annulus-experiment STATIC EXCLUDE_FROM_ALL ${annulus_experiment_sources})
    annulus_describe(annulus-experiment PRIVATE)
    target_link_libraries(annulus-experiment PUBLIC annulus-apps PRIVATE tomlplusplus::tomlplusplus)
    if(ANNULUS_MPI AND MPI_CXX_FOUND)
        target_compile_definitions(annulus-experiment PRIVATE OMPI_SKIP_MPICXX MPICH_SKIP_MPICXX)
        target_link_libraries(annulus-experiment PRIVATE MPI::MPI_CXX)
    endif()
    annulus_unite(annulus-experiment experiment "/experiment/[a-z_]*[.]cpp$")
    file(GLOB annulus_reproduction_sources CONFIGURE_DEPENDS src/apps/reproduction/*.cpp)
    add_library(annulus-reproduction STATIC EXCLUDE_FROM_ALL ${annulus_reproduction_sources})
    annulus_describe(annulus-reproduction PRIVATE)
    target_link_libraries(annulus-reproduction PUBLIC annulus-apps)
    # The code that is benchmarked, ours and CGAL's alike, is optimised like the library.
    target_compile_options(annulus-reproduction PRIVATE
        $<$<COMPILE_LANG_AND_ID:CXX,GNU,Clang,AppleClang>:-fno-math-errno> $<$<CONFIG:Release>:-O3>)
    annulus_unite(annulus-reproduction reproduction "/reproduction/[a-z_]*[.]cpp$")
endif()

# ---- The programs --------------------------------------------------------------------------------
# The library without the parts for natural ODT and without CGAL's view, which the tool does not need: the same objects,
# in archives that are ready as soon as these objects are.
add_library(annulus-tool-core STATIC EXCLUDE_FROM_ALL $<TARGET_OBJECTS:annulus-core-objects>
            $<TARGET_OBJECTS:annulus-arithmetic>)
add_library(annulus-tool-apps STATIC EXCLUDE_FROM_ALL $<TARGET_OBJECTS:annulus-apps-objects>)
set_target_properties(annulus-tool-core annulus-tool-apps PROPERTIES LINKER_LANGUAGE CXX)
annulus_describe(annulus-tool-core PUBLIC)
annulus_describe(annulus-tool-apps PUBLIC)
target_link_libraries(annulus-tool-apps PUBLIC annulus-tool-core ${annulus_apps_packages})

function(annulus_program target library)
    set_target_properties(${target} PROPERTIES CXX_EXTENSIONS OFF)
    target_link_libraries(${target} PUBLIC ${library} CLI11::CLI11 annulus_warnings)
    target_compile_options(${target} PRIVATE ${annulus_compiled_quickly})
    annulus_unite(${target} ${target} "/cli/[a-z_0-9]*[.]cpp$")
endfunction()

file(GLOB annulus_cli_sources CONFIGURE_DEPENDS src/apps/cli/*.cpp)
set(annulus_nodt_sources src/apps/cli/domain_files.cpp src/apps/cli/finishing.cpp src/apps/cli/nodt.cpp
    src/apps/cli/nodt_main.cpp)
set(annulus_sweep_sources src/apps/cli/sweep.cpp src/apps/cli/sweep_main.cpp)
set(annulus_reproduce_sources src/apps/cli/reproduce.cpp src/apps/cli/reproduce_main.cpp
    src/apps/cli/reproduction_scenes.cpp)
set(annulus_solid_scene_sources src/apps/cli/guided_nodt.cpp src/apps/cli/nodt_scene.cpp)
# Shared by all programs: arguments, files, and the scenes of motions.
set(annulus_scene_sources ${annulus_cli_sources})
list(FILTER annulus_scene_sources INCLUDE REGEX "/(arguments|interruption|process|progress|result_files|tool)[.]cpp$|\
/(compare|files|guided_box|guided_motion|input|lloyd_scene|mesh_3|nodt_arguments|print_comparison|replay_scene)[.]cpp$|\
/frame_(arguments|box|clip|files|measures)[.]cpp$|\
/(box_size|boxed_mesh|boxed_scene|image_path|pair_changes|run_tracker|solid_mesh|tracker)[.]cpp$")
list(FILTER annulus_cli_sources EXCLUDE REGEX "/(nodt|sweep|reproduce|nodt_main|sweep_main|reproduce_main|\
reproduction_scenes|guided_nodt|nodt_scene|domain_files|finishing)[.]cpp$")
list(REMOVE_ITEM annulus_cli_sources ${annulus_scene_sources})

add_library(annulus-scenes STATIC EXCLUDE_FROM_ALL ${annulus_scene_sources})
annulus_program(annulus-scenes annulus-tool-apps)
add_executable(annulus-cli ${annulus_cli_sources})
annulus_program(annulus-cli annulus-tool-apps)
target_link_libraries(annulus-cli PRIVATE annulus-scenes)
set_target_properties(annulus-cli PROPERTIES OUTPUT_NAME annulus)
# The directory of the installed companion programs, relative to the directory above that of `annulus`.
target_compile_definitions(annulus-cli PRIVATE ANNULUS_LIBEXEC="${CMAKE_INSTALL_LIBEXECDIR}/annulus")

add_library(annulus-solid-scenes STATIC EXCLUDE_FROM_ALL ${annulus_solid_scene_sources}
            $<TARGET_OBJECTS:annulus-solids>)
annulus_program(annulus-solid-scenes annulus-scenes)
add_executable(annulus-nodt ${annulus_nodt_sources})
annulus_program(annulus-nodt annulus-solid-scenes)
if(ANNULUS_BUILD_STUDIES)
    add_executable(annulus-sweep ${annulus_sweep_sources})
    add_executable(annulus-reproduce ${annulus_reproduce_sources})
    annulus_program(annulus-sweep annulus-scenes)
    annulus_program(annulus-reproduce annulus-solid-scenes)
    target_link_libraries(annulus-sweep PRIVATE annulus-experiment)
    target_link_libraries(annulus-reproduce PRIVATE annulus-reproduction)
    add_custom_target(annulus-programs DEPENDS annulus-cli annulus-nodt annulus-sweep annulus-reproduce)
endif()
