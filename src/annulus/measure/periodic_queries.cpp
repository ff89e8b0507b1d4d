// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_queries.h>

#include <annulus/kernel/periodic_locate.h>
#include <annulus/measure/periodic_natural.h>
#include <annulus/measure/periodic_nearest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace annulus::inline v1 {

template <int d>
template <class With>
void Periodic_queries<d>::for_each_located(Points points, With with) const {
    if (state_.table.size() == 0) return;
    for (std::size_t k = 0; k < points.size(); ++k) {
        if (std::any_of(points[k].begin(), points[k].end(), [](double c) { return std::isnan(c); })) continue;
        const Representative<d> r = state_.lattice.representative(points[k], static_cast<std::int64_t>(k));
        const Lifted_cell<d> at = locate<d>(state_.table, state_.lattice, state_.place, r.place);
        with(k, r, Lifted_cell<d>{at.cell, Offset<d>{} - at.shift});
    }
}

template <int d>
Periodic_image<d> Periodic_queries<d>::named(Image<d> image, const Representative<d>& beside) const {
    Periodic_image<d> out{image.vertex, state_.shift(image, true)};
    for (std::size_t i = 0; i < d; ++i) out.shift[i] += beside.image[i];
    return out;
}

template <int d>
std::vector<Periodic_location<d>> Periodic_queries<d>::cells(Points points) const {
    std::vector<Periodic_location<d>> found(points.size());
    for_each_located(points, [&](std::size_t k, const Representative<d>& r, Lifted_cell<d> at) {
        const Shift<d> least = state_.least_shift(at.cell, true);  // what cells() subtracts
        const Shift<d> seen = state_.lattice.in_box(at.shift);
        found[k].cell = static_cast<Index>(at.cell);
        for (std::size_t i = 0; i < d; ++i) found[k].shift[i] = least[i] + seen[i] + r.image[i];
    });
    return found;
}

template <int d>
std::vector<Periodic_image<d>> Periodic_queries<d>::nearest(Points points) const {
    std::vector<Periodic_image<d>> found(points.size());
    for_each_located(points, [&](std::size_t k, const Representative<d>& r, Lifted_cell<d> at) {
        const Lifted_corner<d> c = nearest_corner<d>(state_.table, state_.lattice, state_.place, r.place, at);
        found[k] = named(state_.table.image(c.at.cell, c.slot, c.at.shift), r);
    });
    return found;
}

template <int d>
Periodic_weights<d> Periodic_queries<d>::natural_neighbours(Points points) const {
    const Periodic_natural_neighbours<d> neighbours({state_.table, state_.lattice, state_.place});
    Periodic_weights<d> out;
    out.begin.reserve(points.size() + 1);
    for_each_located(points, [&](std::size_t k, const Representative<d>& r, Lifted_cell<d> at) {
        const Weighted_images<d> found = neighbours.of(r.place, at);
        out.begin.resize(k + 1, out.image.size());  // those that were left out have none
        for (const Image<d> s : found.image) out.image.push_back(named(s, r));
        out.weight.insert(out.weight.end(), found.weight.begin(), found.weight.end());
    });
    out.begin.resize(points.size() + 1, out.image.size());
    return out;
}

template class Periodic_queries<2>;
template class Periodic_queries<3>;

}  // namespace annulus::inline v1
