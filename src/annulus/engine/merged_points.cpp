// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/merged_points.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>

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

/// The same for all images of a place: of those in the cell of the basis, widened by the border, the least.
template <int d>
Coordinates<d> least_image(const Lattice<d>& lattice, const Coordinates<d>& place) {
    const Coordinates<d> f = lattice.in_basis(place);
    Shift<d> home, s;
    for (std::size_t i = 0; i < d; ++i) home[i] = -static_cast<std::int32_t>(std::floor(f[i]));
    Coordinates<d> least = lattice.place(place, Offset<d>(home));
    if (is_in_cell<d>(lattice, least, -border)) return least;
    s.fill(-1);
    for (std::size_t i = 0; i < d;) {
        const Coordinates<d> x = lattice.place(place, Offset<d>(home) + Offset<d>(s));
        if (is_in_cell<d>(lattice, x, border)) least = std::min(least, x);
        for (i = 0; i < d && ++s[i] > 1; ++i) s[i] = -1;
    }
    return least;
}

}  // namespace

template <int d>
Merged_points<d> merged_points(const Lattice<d>& lattice, std::span<const Coordinates<d>> points,
                               std::span<const Coordinates<d>> place) {
    Merged_points<d> merged;
    merged.vertex.reserve(points.size());
    std::map<Coordinates<d>, Index> seen;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto [it, is_new] =
            seen.emplace(least_image<d>(lattice, place[k]), static_cast<Index>(merged.distinct.size()));
        if (is_new) merged.distinct.push_back(points[k]);
        merged.vertex.push_back(it->second);
    }
    return merged;
}

template Merged_points<2> merged_points(const Lattice<2>&, std::span<const Coordinates<2>>,
                                        std::span<const Coordinates<2>>);
template Merged_points<3> merged_points(const Lattice<3>&, std::span<const Coordinates<3>>,
                                        std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
