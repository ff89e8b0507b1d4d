// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/merged_points.h>

#include <annulus/space/first_at_place.h>
#include <annulus/space/least_image.h>

#include <cstddef>

namespace annulus::inline v1 {

template <int d>
std::vector<Coordinates<d>> least_images(const Lattice<d>& lattice, std::vector<Coordinates<d>> place) {
    for (Coordinates<d>& p : place) p = least_image<d>(lattice, p);
    return place;
}

template <int d>
Merged_points<d> merged_points(const Lattice<d>& lattice, std::span<const Coordinates<d>> points,
                               std::span<const Coordinates<d>> place) {
    const std::vector<std::size_t> first = first_at_place<d>(least_images<d>(lattice, {place.begin(), place.end()}));
    Merged_points<d> merged;
    for (std::size_t k = 0; k < points.size(); ++k) {
        const bool is_new = first[k] == k;
        merged.vertex.push_back(is_new ? static_cast<Index>(merged.distinct.size()) : merged.vertex[first[k]]);
        if (is_new) merged.distinct.push_back(points[k]);
    }
    return merged;
}

template std::vector<Coordinates<2>> least_images(const Lattice<2>&, std::vector<Coordinates<2>>);
template std::vector<Coordinates<3>> least_images(const Lattice<3>&, std::vector<Coordinates<3>>);
template Merged_points<2> merged_points(const Lattice<2>&, std::span<const Coordinates<2>>,
                                        std::span<const Coordinates<2>>);
template Merged_points<3> merged_points(const Lattice<3>&, std::span<const Coordinates<3>>,
                                        std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
