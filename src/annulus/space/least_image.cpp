// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/space/least_image.h>

#include <annulus/space/for_each_shift.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

namespace {

// In coordinates of the basis, and far more than in_basis rounds.
constexpr double border = 1e-9;

template <int d>
bool is_in_cell(const Lattice<d>& lattice, const Coordinates<d>& place, double margin) {
    for (const double c : lattice.in_basis(place))
        if (c < -margin || c > 1 + margin) return false;
    return true;
}

}  // namespace

template <int d>
Coordinates<d> least_image(const Lattice<d>& lattice, const Coordinates<d>& place) {
    const Coordinates<d> f = lattice.in_basis(place);
    Shift<d> home;
    for (std::size_t i = 0; i < d; ++i) home[i] = -static_cast<std::int32_t>(std::floor(f[i]));
    Coordinates<d> least = lattice.place(place, Offset<d>(home));
    if (is_in_cell<d>(lattice, least, -border)) return least;
    for_each_shift<d>(1, [&](const Shift<d>& s) {
        const Coordinates<d> x = lattice.place(place, Offset<d>(home) + Offset<d>(s));
        if (is_in_cell<d>(lattice, x, border)) least = std::min(least, x);
    });
    return least;
}

template Coordinates<2> least_image(const Lattice<2>&, const Coordinates<2>&);
template Coordinates<3> least_image(const Lattice<3>&, const Coordinates<3>&);

}  // namespace annulus::inline v1
