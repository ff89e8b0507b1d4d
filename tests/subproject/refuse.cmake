# SPDX-License-Identifier: GPL-3.0-or-later
# Fails where FLAGS are refused.
include("${CMAKE_CURRENT_LIST_DIR}/../../cmake/annulus-flags.cmake")
annulus_refuse_flags("${FLAGS}" FLAGS)
