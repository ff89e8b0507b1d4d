// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>

#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

/// Calls visit(shift) for every shift with coordinates from -most to most, the first coordinate fastest.
template <int d, class Visit>
void for_each_shift(std::int32_t most, Visit visit) {
    Shift<d> s;
    s.fill(-most);
    for (std::size_t i = 0; i < d;) {
        visit(s);
        for (i = 0; i < d && ++s[i] > most; ++i) s[i] = -most;
    }
}

}  // namespace annulus::inline v1
