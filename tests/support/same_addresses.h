// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <sys/personality.h>
#include <unistd.h>

namespace annulus::testing {

/// CGAL removes a vertex of space in an order that depends on addresses, and with it go the numbers of cells. So that
/// a seed means the same run, the program starts again without the randomisation of addresses, where the system allows
/// it; else it goes on as it is. To be called first of all: what was printed or opened before would be twice.
inline void same_addresses_every_time(char* argv[]) {
    const int persona = personality(0xffffffff);
    if (persona == -1 || (persona & ADDR_NO_RANDOMIZE) != 0) return;
    if (personality(static_cast<unsigned long>(persona) | ADDR_NO_RANDOMIZE) == -1) return;
    execv("/proc/self/exe", argv);  // returns only if it fails
}

}  // namespace annulus::testing
