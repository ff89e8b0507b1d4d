// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/coinciding_images.h>

#include <annulus/arithmetic/duplicate_point.h>
#include <annulus/space/least_image.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

template <int d>
Error coinciding_images_error(const Lattice<d>& lattice, std::span<const Coordinates<d>> place) {
    std::map<Coordinates<d>, std::vector<std::int64_t>> at;
    for (std::size_t i = 0; i < place.size(); ++i)
        if (is_place<d>(place[i])) at[least_image<d>(lattice, place[i])].push_back(static_cast<std::int64_t>(i));
    std::vector<std::int64_t> lowest;
    for (auto& [image, vertices] : at)
        if (vertices.size() > 1 && (lowest.empty() || vertices < lowest)) lowest = std::move(vertices);
    return duplicate_point_error("points", "have, up to vectors of the box,", std::move(lowest));
}

template Error coinciding_images_error(const Lattice<2>&, std::span<const Coordinates<2>>);
template Error coinciding_images_error(const Lattice<3>&, std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
