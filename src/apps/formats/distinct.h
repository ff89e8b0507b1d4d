// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/engine/merged_points.h>
#include <annulus/space/first_at_place.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// The same in a periodic box: for each point the first one of which it is an image, both rounded to the grid of the
/// box. Throws not_finite, and out_of_domain for a point more than 2^29 boxes away; the error names it. O(n log n).
template <int d>
[[nodiscard]] std::vector<std::size_t> first_at_place(std::span<const Coordinates<d>> x, const Box<d>& box) {
    const Lattice<d> lattice(box.vectors());
    std::vector<Coordinates<d>> place, given;
    std::vector<Shift<d>> image;
    lattice.represent(x, place, image, given);
    return first_at_place<d>(least_images<d>(lattice, std::move(place)));
}

/// Keeps what is of points that are the first at their places, `of_each` being of all points.
template <class T>
void keep_first(std::span<const std::size_t> first, std::vector<T>& of_each) {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < first.size(); ++i)
        if (first[i] == i) of_each[kept++] = of_each[i];
    of_each.resize(kept);
}

}  // namespace annulus::inline v1
