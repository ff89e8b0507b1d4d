// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/formats/mesh_part.h>

namespace annulus::inline v1 {

Mesh_part mesh_part(std::span<const Coordinates<3>> points, std::span<const std::array<Index, 4>> cells,
                    std::span<const std::array<Index, 3>> boundary) {
    std::vector<Index> number(points.size(), none);
    const auto require = [&](Index v) {
        if (v < 0 || static_cast<std::size_t>(v) >= points.size())
            throw Error(Error_code::unknown_vertex, "mesh_part: a cell names no point");
    };
    for (const auto& c : cells)
        for (const Index v : c) {
            require(v);
            number[static_cast<std::size_t>(v)] = 0;
        }
    Mesh_part part;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] == none) continue;
        number[v] = static_cast<Index>(part.points.size());
        part.points.push_back(points[v]);
    }
    part.tetrahedra.assign(cells.begin(), cells.end());
    part.triangles.assign(boundary.begin(), boundary.end());
    for (auto& c : part.tetrahedra)
        for (Index& v : c) v = number[static_cast<std::size_t>(v)];
    for (auto& c : part.triangles)
        for (Index& v : c) {
            require(v);
            v = number[static_cast<std::size_t>(v)];
            if (v == none) throw Error(Error_code::unknown_vertex, "mesh_part: a triangle is of no cell");
        }
    return part;
}

}  // namespace annulus::inline v1
