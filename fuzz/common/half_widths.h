// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Half widths of the certificates of the plane in rational arithmetic.

#include <annulus/types.h>

#include <gmpxx.h>

namespace annulus::oracle {

inline constexpr mp_bitcnt_t precision = 320;

/// Half the least altitude of a triangle that turns left, to 300 bits; 0 when it does not.
[[nodiscard]] mpf_class half_altitude(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c);
/// Half the width of the standard annulus of the edge a b, p right of it and q left, by its centre; 0 when the circle
/// is not empty.
[[nodiscard]] mpf_class half_annulus(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& p,
                                     const Coordinates<2>& q);

}  // namespace annulus::oracle
