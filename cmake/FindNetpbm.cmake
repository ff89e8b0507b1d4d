# SPDX-License-Identifier: GPL-3.0-or-later
# Netpbm's library, as Netpbm::Netpbm: neither CMake nor Netpbm itself has a file that finds it.
find_path(Netpbm_INCLUDE_DIR netpbm/pam.h)
find_library(Netpbm_LIBRARY netpbm)
mark_as_advanced(Netpbm_INCLUDE_DIR Netpbm_LIBRARY)
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(Netpbm REQUIRED_VARS Netpbm_LIBRARY Netpbm_INCLUDE_DIR)
if(Netpbm_FOUND AND NOT TARGET Netpbm::Netpbm)
    add_library(Netpbm::Netpbm UNKNOWN IMPORTED)
    set_target_properties(Netpbm::Netpbm PROPERTIES IMPORTED_LOCATION "${Netpbm_LIBRARY}"
                          INTERFACE_INCLUDE_DIRECTORIES "${Netpbm_INCLUDE_DIR}")
endif()
