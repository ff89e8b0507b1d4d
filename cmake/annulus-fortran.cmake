# SPDX-License-Identifier: GPL-3.0-or-later
# The modules of Fortran are installed as one source file, annulus.f90, in which each part comes after those that it
# uses: a module that is compiled can be read by one version of one compiler only.
set(annulus_fortran_file "${PROJECT_BINARY_DIR}/fortran/annulus.f90")
set(annulus_fortran_text "")
foreach(part IN ITEMS annulus_types annulus_c annulus_common annulus_meshes meshes_changes meshes_measures meshes_lists
        annulus_periodic periodic_changes periodic_measures periodic_lists annulus_predicates annulus)
    set(annulus_fortran_part "${PROJECT_SOURCE_DIR}/fortran/${part}.f90")
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${annulus_fortran_part}")
    file(READ "${annulus_fortran_part}" annulus_fortran_lines)
    string(APPEND annulus_fortran_text "${annulus_fortran_lines}\n")
endforeach()
file(CONFIGURE OUTPUT "${annulus_fortran_file}" CONTENT "${annulus_fortran_text}" @ONLY)
