// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>
#include <annulus/predicate/exact_sign.h>
#include <annulus/types.h>

#include <array>
#include <cstddef>

namespace annulus::inline v1 {

/// Whether p is inside the circumscribed circle or sphere of a positive cell, or on it: exactly. Precondition: rounding
/// is to nearest.
template <int d>
[[nodiscard]] bool is_in_sphere(const std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)>& cell,
                                const Coordinates<d>& p) {
    const auto outside = [&](const auto& sphere, const Tuple<d, d + 2>& in_order) {
        if (sphere.positive() && sphere.contains(p)) return false;
        if (sphere.positive() && sphere.excludes(p)) return true;
        return exact_empty_sphere_sign(in_order).sign > 0;
    };
    if constexpr (d == 2)
        return !outside(Circumcircle_2(cell[0], cell[1], cell[2]), {&cell[0], &cell[1], &p, &cell[2]});
    else
        return !outside(Circumsphere_3(cell[0], cell[1], cell[2], cell[3]),
                        {&cell[0], &cell[1], &cell[2], &p, &cell[3]});
}

}  // namespace annulus::inline v1
