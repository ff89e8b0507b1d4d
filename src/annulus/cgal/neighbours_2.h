// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/neighbours.h>

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus {

/// The neighbours of every vertex of CGAL's triangulation of the plane; handle[i] is vertex i, null where the index is vacant. O(n).
template <class Tr>
void read_neighbours(const Tr& tr, std::span<const typename Tr::Vertex_handle> handle, Neighbours_2& out) {
    out.begin.assign(1, 0);
    out.vertex.clear();
    out.hull.clear();
    out.vertex.reserve(6 * handle.size());
    std::vector<Index> ring;
    for (const auto v : handle) {
        const bool lives = v != typename Tr::Vertex_handle();
        bool hull = lives && tr.dimension() != 2;
        ring.clear();
        if (lives && tr.dimension() >= 1) {
            std::size_t start = 0;  // where the list begins: after infinity
            auto w = tr.incident_vertices(v);
            const auto done = w;
            do {
                if (tr.is_infinite(w)) {
                    hull = true;
                    start = ring.size();
                } else {
                    ring.push_back(w->index());
                }
            } while (++w != done);
            if (tr.dimension() == 2)
                std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(start), ring.end());
        }
        out.vertex.insert(out.vertex.end(), ring.begin(), ring.end());
        out.begin.push_back(static_cast<Index>(out.vertex.size()));
        out.hull.push_back(hull ? 1 : 0);
    }
}

}  // namespace annulus
