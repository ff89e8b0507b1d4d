// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/merged_points.h>

#include <annulus/space/least_image.h>

#include <cstddef>
#include <map>

namespace annulus::inline v1 {

template <int d>
std::vector<Coordinates<d>> least_images(const Lattice<d>& lattice, std::vector<Coordinates<d>> place) {
    for (Coordinates<d>& p : place) p = least_image<d>(lattice, p);
    return place;
}

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

template std::vector<Coordinates<2>> least_images(const Lattice<2>&, std::vector<Coordinates<2>>);
template std::vector<Coordinates<3>> least_images(const Lattice<3>&, std::vector<Coordinates<3>>);
template Merged_points<2> merged_points(const Lattice<2>&, std::span<const Coordinates<2>>,
                                        std::span<const Coordinates<2>>);
template Merged_points<3> merged_points(const Lattice<3>&, std::span<const Coordinates<3>>,
                                        std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
