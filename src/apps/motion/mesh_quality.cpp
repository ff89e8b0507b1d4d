// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/mesh_quality.h>

#include <annulus/error.h>
#include <apps/motion/dihedral.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace annulus::inline v1 {

Mesh_quality mesh_quality(const Mesh_cells<3>& cells, std::span<const char> inside,
                          std::span<const Coordinates<3>> position) {
    if (inside.size() != cells.vertices.size())
        throw Error(Error_code::wrong_size, "mesh_quality needs a flag for every cell");
    Mesh_quality q;
    std::vector<char> kind(position.size(), 0);
    for (std::size_t c = 0; c < cells.vertices.size(); ++c)
        for (const Index v : cells.vertices[c])
            if (inside[c] != 0) kind[static_cast<std::size_t>(v)] = 1;
    for (const auto& facet : surface_facets(cells, inside))
        for (const Index v : facet) kind[static_cast<std::size_t>(v)] = 2;
    for (const char k : kind) {
        q.vertices += k > 0;
        q.boundary += k > 1;
    }
    for (std::size_t c = 0; c < cells.vertices.size(); ++c) {
        if (inside[c] == 0) continue;
        const auto x = [&](std::size_t i) { return position[static_cast<std::size_t>(cells.vertices[c][i])]; };
        ++q.cells;
        bool good = true;
        for (const double cosine : dihedral_cosines(x(0), x(1), x(2), x(3))) {
            const double degrees = std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
            q.dihedral.add(degrees);
            good = good && degrees >= Mesh_quality::sliver_degrees && degrees <= 180 - Mesh_quality::sliver_degrees;
        }
        q.slivers += !good;
    }
    return q;
}

}  // namespace annulus::inline v1
