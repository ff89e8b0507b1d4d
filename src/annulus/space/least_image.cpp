// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/space/least_image.h>

#include <annulus/space/for_each_shift.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

namespace {

/// Whether the coordinates in the basis are from 0 to 1, with so many times what in_basis rounds more on both sides.
template <int d>
bool is_in_cell(const Lattice<d>& lattice, const Coordinates<d>& place, double more) {
    const Coordinates<d> f = lattice.in_basis(place);
    for (std::size_t j = 0; j < d; ++j) {
        const double margin = more * lattice.rounding()[j];
        if (f[j] < -margin || f[j] > 1 + margin) return false;
    }
    return true;
}

}  // namespace

/// Whatever image it is given, it takes the least of those that are, as they are computed, in the cell widened by what
/// is rounded: there is one, since an image is in the cell. Where one is inside by three times as much, no other is.
/// Images farther than one vector from `home` are in the widened cell only where that is much wider.
template <int d>
Coordinates<d> least_image(const Lattice<d>& lattice, const Coordinates<d>& place) {
    const Coordinates<d> f = lattice.in_basis(place);
    Shift<d> home;
    for (std::size_t i = 0; i < d; ++i) home[i] = -static_cast<std::int32_t>(std::floor(f[i]));
    Coordinates<d> least = lattice.place(place, Offset<d>(home));
    if (is_in_cell<d>(lattice, least, -3)) return least;
    bool found = false;
    const Coordinates<d>& rounding = lattice.rounding();
    const bool is_wide = *std::max_element(rounding.begin(), rounding.end()) > 0.25;
    for_each_shift<d>(is_wide ? 3 : 1, [&](const Shift<d>& s) {
        const Coordinates<d> x = lattice.place(place, Offset<d>(home) + Offset<d>(s));
        if (!is_in_cell<d>(lattice, x, 1)) return;
        least = found ? std::min(least, x) : x;
        found = true;
    });
    return least;
}

template Coordinates<2> least_image(const Lattice<2>&, const Coordinates<2>&);
template Coordinates<3> least_image(const Lattice<3>&, const Coordinates<3>&);

}  // namespace annulus::inline v1
