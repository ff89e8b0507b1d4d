// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The C++ standard that every header here needs. A header that includes no other header of annulus includes this one
// first, so that a compiler with an older standard reports this error, not errors about the standard library.
#if __cplusplus < 202002L
#error "annulus: compile with -std=c++20 or a later standard"
#endif
