// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The standard of C++ that every header here needs. Headers that include nothing else of annulus include this first,
// so that a compiler with an older standard says this, and not what it does not know in the standard library.
#if __cplusplus < 202002L
#error "annulus: compile with -std=c++20 or a later standard"
#endif
