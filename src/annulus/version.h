// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The version of these headers, for C++ and C; CMakeLists.txt has the same, and fails where the two differ. The version
// of the shared library at run time is annulus_version() of annulus.h.
//
// All names of the C++ library are in the inline namespace annulus::v1, so that two versions can be linked into one
// program: the number after v grows where objects of two versions cannot be exchanged.
#define ANNULUS_VERSION_MAJOR 0
#define ANNULUS_VERSION_MINOR 1
#define ANNULUS_VERSION_PATCH 0
// For #if: 10,000 times the major, plus 100 times the minor, plus the patch number.
#define ANNULUS_VERSION (ANNULUS_VERSION_MAJOR * 10000 + ANNULUS_VERSION_MINOR * 100 + ANNULUS_VERSION_PATCH)
#define ANNULUS_VERSION_STRING "0.1.0"
