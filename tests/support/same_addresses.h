// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/personality.h>
#include <unistd.h>

namespace annulus::testing {

/// In 3D CGAL fills the hole of a removed vertex in an order that depends on addresses, and so do the numbers of cells.
/// So that a seed gives the same run, the program starts again without address randomisation where the system allows
/// it; otherwise it continues. Call it first: output or files from before would occur twice.
inline void same_addresses_every_time(char* argv[]) {
    const int persona = personality(0xffffffff);
    if (persona == -1 || (persona & ADDR_NO_RANDOMIZE) != 0) return;
    if (personality(static_cast<unsigned long>(persona) | ADDR_NO_RANDOMIZE) == -1) return;
    execv("/proc/self/exe", argv);  // returns only if it fails
}

}  // namespace annulus::testing
