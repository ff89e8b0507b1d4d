// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_natural.h>

#include <annulus/measure/laplace_weights.h>
#include <annulus/measure/sphere_side.h>
#include <annulus/space/for_each_shift.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <set>
#include <utility>

namespace annulus::inline v1 {

/// Edges have coordinates of at most `reach` in the basis, 2.5 or less.
template <int d>
Periodic_natural_neighbours<d>::Periodic_natural_neighbours(const Periodic_view<d>& view) : view_(view) {
    for_each_shift<d>(2, [this](const Shift<d>& o) {
        const Coordinates<d> way = view_.lattice.place({}, Offset<d>(o));
        bool in_reach = true;
        double squares = 0;
        for (std::size_t k = 0; k < d; ++k) {
            in_reach = in_reach && std::abs(o[k]) <= view_.lattice.reach()[k];
            squares += way[k] * way[k];
        }
        if (in_reach && squares > 0) own_.push_back({Offset<d>(o), std::sqrt(squares)});
    });
}

template <int d>
Weighted_images<d> Periodic_natural_neighbours<d>::of(const Coordinates<d>& p, Lifted_cell<d> start) const {
    const std::vector<Image<d>> images =
        images_around(p, nearest_corner<d>(view_.table, view_.lattice, view_.place, p, start));
    std::vector<Coordinates<d>> near;
    for (const Image<d> s : images) near.push_back(at(s));
    Laplace_weights found = laplace_weights<d>(near, p);
    for (const Own_image& own : own_)
        if (own.length <= found.reach_upper) near.push_back(view_.lattice.place(p, own.offset));
    if (near.size() > images.size()) found = laplace_weights<d>(near, p, images.size());
    Weighted_images<d> out;
    for (const std::size_t k : found.point) out.image.push_back(images[k]);
    out.weight = std::move(found.weight);
    return out;
}

/// The corners of the cells that have p inside their sphere, and a corner that an edge may lead to from p. Along a way
/// within the cell that p would have from p to any of its facets, one is always within cells of such images, which is
/// why they are found from cell to cell. Without the second condition cells in a thin box would be very many.
template <int d>
std::vector<Image<d>> Periodic_natural_neighbours<d>::images_around(const Coordinates<d>& p,
                                                                    const Lifted_corner<d>& nearest) const {
    const Image<d> centre = view_.table.image(nearest.at.cell, nearest.slot, nearest.at.shift);
    std::set<std::pair<std::size_t, Offset<d>>> met{{nearest.at.cell, nearest.at.shift}};
    std::vector<Lifted_cell<d>> open{nearest.at};  // first all around the nearest image, some of which have p inside
    std::vector<Image<d>> images{centre};
    while (!open.empty()) {
        const Lifted_cell<d> c = open.back();
        open.pop_back();
        const auto corners = view_.table.images(c.cell, c.shift);
        const bool inside = is_in_sphere(p, c);
        if (inside) images.insert(images.end(), corners.begin(), corners.end());
        for (std::size_t i = 0; i <= d; ++i) {
            const bool around =
                corners[i] != centre && std::find(corners.begin(), corners.end(), centre) != corners.end();
            if (!inside && !around) continue;
            const Lifted_cell<d> next = beyond(view_.table, c, i);
            if ((around || is_in_reach(p, next)) && met.emplace(next.cell, next.shift).second) open.push_back(next);
        }
    }
    std::sort(images.begin(), images.end());
    images.erase(std::unique(images.begin(), images.end()), images.end());
    return images;
}

template <int d>
bool Periodic_natural_neighbours<d>::is_in_reach(const Coordinates<d>& p, Lifted_cell<d> c) const {
    for (const Image<d> s : view_.table.images(c.cell, c.shift)) {
        Coordinates<d> way = at(s);
        for (std::size_t i = 0; i < d; ++i) way[i] -= p[i];
        way = view_.lattice.in_basis(way);
        bool in_reach = true;
        for (std::size_t i = 0; i < d; ++i) in_reach = in_reach && std::fabs(way[i]) <= view_.lattice.reach()[i];
        if (in_reach) return true;
    }
    return false;
}

template <int d>
bool Periodic_natural_neighbours<d>::is_in_sphere(const Coordinates<d>& p, Lifted_cell<d> c) const {
    std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)> x;
    for (std::size_t i = 0; i <= d; ++i) x[i] = at(view_.table.image(c.cell, i, c.shift));
    return annulus::is_in_sphere<d>(x, p);
}

template class Periodic_natural_neighbours<2>;
template class Periodic_natural_neighbours<3>;

}  // namespace annulus::inline v1
