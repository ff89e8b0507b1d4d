# SPDX-License-Identifier: GPL-3.0-or-later
# Fails where FLAGS, or the compiler COMPILER_ID, are refused.
include("${CMAKE_CURRENT_LIST_DIR}/../../cmake/annulus-flags.cmake")
annulus_refuse_flags("${FLAGS}" FLAGS)
if(DEFINED COMPILER_ID)
    annulus_refuse_compiler("${COMPILER_ID}")
endif()
