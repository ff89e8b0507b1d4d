// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The structs of annulus.h, which grow: their first member says how much of one its owner knows.

#include <annulus/c/barrier.h>

#include <algorithm>
#include <cstring>

namespace annulus::c {

/// Of these and later versions: from one size_t to what no version will reach.
inline void require_struct(std::size_t size, std::size_t least, const char* name) {
    if (size < least || size > 65536)
        throw Refused(ANNULUS_USAGE,
                      std::string(name) + ".size is " + std::to_string(size) + ": set it to sizeof(" + name + ")");
}

/// Writes what its owner knows of a struct; of what the library does not know it leaves alone.
template <class Struct>
void write_struct(Struct* to, Struct value) {
    value.size = to->size;
    std::memcpy(to, &value, std::min(to->size, sizeof(Struct)));
}

/// NULL gives the defaults. Throws Refused for names and sizes that there are not.
[[nodiscard]] Options options_of(const annulus_options* given);

inline void require_report(const annulus_report* report) {
    if (report != nullptr) require_struct(report->size, sizeof(report->size), "annulus_report");
}
/// changed: numbers in Move_report::changed, d + 1 a cell.
void write_report(annulus_report* to, const Move_report& done, int dimension, std::size_t changed);

}  // namespace annulus::c
