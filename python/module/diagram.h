// SPDX-License-Identifier: GPL-3.0-or-later
// Voronoi diagrams, with and without a box, as dicts of arrays.
#pragma once

#include <module/parts.h>

#include <annulus/voronoi.h>

#include <memory>
#include <utility>
#include <vector>

namespace annulus::python {

/// NumPy's bool is a byte that is 0 or 1.
inline py::array give_flags(std::vector<char> flags) {
    static_assert(sizeof(bool) == 1);
    auto owner = std::make_shared<const std::vector<char>>(std::move(flags));
    const auto n = static_cast<py::ssize_t>(owner->size());
    const auto* const data = reinterpret_cast<const bool*>(owner->data());
    return view<bool>(data, {n}, std::move(owner));
}

/// What annulus.Voronoi is made of.
template <int d>
py::dict diagram_dict(std::vector<Coordinates<d>> points, Voronoi_diagram<d> v) {
    py::dict out;
    out["points"] = give_rows(std::move(points));
    out["pairs"] = give_rows(std::move(v.pair));
    out["areas"] = give(std::move(v.measure));
    out["facet_centroids"] = give_rows(std::move(v.centroid));
    out["distances"] = give(std::move(v.distance));
    out["vectors"] = give_rows(std::move(v.vector));
    out["exactly_empty"] = give_flags(std::move(v.exactly_empty));
    out["ring_begin"] = give(std::move(v.ring_begin));
    out["ring"] = give(std::move(v.ring));
    out["vertices"] = give_rows(std::move(v.vertex));
    out["vertex_of_simplex"] = give(std::move(v.vertex_of_cell));
    out["volumes"] = give(std::move(v.volume));
    out["centroids"] = give_rows(std::move(v.cell_centroid));
    out["surfaces"] = give(std::move(v.surface));
    return out;
}

}  // namespace annulus::python
