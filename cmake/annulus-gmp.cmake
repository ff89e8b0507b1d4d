# SPDX-License-Identifier: GPL-3.0-or-later
# The target annulus::gmp: GMP, its C++ classes and MPFR, which have no CMake configuration. Installed beside
# annulusConfig.cmake, so that the library and its users find them the same way.

if(NOT TARGET annulus::gmp)
    find_path(ANNULUS_GMPXX_INCLUDE_DIR gmpxx.h)
    find_path(ANNULUS_GMP_INCLUDE_DIR gmp.h)
    find_path(ANNULUS_MPFR_INCLUDE_DIR mpfr.h)
    find_library(ANNULUS_GMPXX_LIBRARY gmpxx)
    find_library(ANNULUS_GMP_LIBRARY gmp)
    find_library(ANNULUS_MPFR_LIBRARY mpfr)
    mark_as_advanced(
        ANNULUS_GMPXX_INCLUDE_DIR ANNULUS_GMP_INCLUDE_DIR ANNULUS_MPFR_INCLUDE_DIR
        ANNULUS_GMPXX_LIBRARY ANNULUS_GMP_LIBRARY ANNULUS_MPFR_LIBRARY)
    foreach(annulus_gmp_part IN ITEMS
            GMPXX_INCLUDE_DIR GMP_INCLUDE_DIR MPFR_INCLUDE_DIR GMPXX_LIBRARY GMP_LIBRARY MPFR_LIBRARY)
        if(NOT ANNULUS_${annulus_gmp_part})
            message(FATAL_ERROR "annulus needs GMP with its C++ classes and MPFR (libgmp-dev, libmpfr-dev): "
                                "ANNULUS_${annulus_gmp_part} was not found")
        endif()
    endforeach()

    add_library(annulus::gmp INTERFACE IMPORTED)
    target_include_directories(annulus::gmp INTERFACE
        "${ANNULUS_GMPXX_INCLUDE_DIR}" "${ANNULUS_GMP_INCLUDE_DIR}" "${ANNULUS_MPFR_INCLUDE_DIR}")
    target_link_libraries(annulus::gmp INTERFACE
        "${ANNULUS_MPFR_LIBRARY}" "${ANNULUS_GMPXX_LIBRARY}" "${ANNULUS_GMP_LIBRARY}")
endif()
