// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/merged_points.h>

#include <annulus/space/least_image.h>

#include <algorithm>
#include <cstddef>
#include <utility>

namespace annulus::inline v1 {

template <int d>
std::vector<Coordinates<d>> least_images(const Lattice<d>& lattice, std::vector<Coordinates<d>> place) {
    for (Coordinates<d>& p : place) p = least_image<d>(lattice, p);
    return place;
}

template <int d>
Merged_points<d> merged_points(const Lattice<d>& lattice, std::span<const Coordinates<d>> points,
                               std::span<const Coordinates<d>> place) {
    std::vector<std::pair<Coordinates<d>, Index>> images;
    for (std::size_t k = 0; k < points.size(); ++k)
        images.emplace_back(least_image<d>(lattice, place[k]), static_cast<Index>(k));
    std::sort(images.begin(), images.end());
    Merged_points<d> merged;
    merged.vertex.resize(points.size());  // at first the first point at the same place
    for (std::size_t i = 0, first = 0; i < images.size(); ++i) {
        if (images[i].first != images[first].first) first = i;
        merged.vertex[static_cast<std::size_t>(images[i].second)] = images[first].second;
    }
    for (std::size_t k = 0; k < points.size(); ++k) {
        const auto first = static_cast<std::size_t>(merged.vertex[k]);
        if (first < k) {
            merged.vertex[k] = merged.vertex[first];
            continue;
        }
        merged.vertex[k] = static_cast<Index>(merged.distinct.size());
        merged.distinct.push_back(points[k]);
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
