// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/read_neighbours.h>

#include <algorithm>
#include <array>
#include <iterator>

namespace annulus::inline v1 {

namespace {

/// For vertices on a line: the vertices before and after each.
std::vector<std::array<Index, 2>> neighbours_on_a_line(const Delaunay_mesh<2>& mesh,
                                                       std::span<const Coordinates<2>> x) {
    std::vector<std::array<Index, 2>> beside(mesh.vertex_bound(), {none, none});
    std::vector<Index> segments;
    mesh.list_cells(x, segments);
    for (std::size_t k = 0; k < segments.size(); k += 3) {
        beside[static_cast<std::size_t>(segments[k])][1] = segments[k + 1];
        beside[static_cast<std::size_t>(segments[k + 1])][0] = segments[k];
    }
    return beside;
}

/// The neighbours of v, counter-clockwise, starting after infinity where that is a neighbour. Returns whether it is.
bool read_ring(const Corner_table<2>& t, Index v, std::vector<Index>& ring) {
    bool hull = false;
    std::size_t start = 0;
    ring.clear();
    t.for_each_corner(v, [&](Corner_index h) {
        const Index w = t.vertex(t.ccw(h));
        if (w != infinite) return ring.push_back(w);
        hull = true;
        start = ring.size();
    });
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(start), ring.end());
    return hull;
}

}  // namespace

void read_neighbours(const Delaunay_mesh<2>& mesh, std::span<const Coordinates<2>> x, Neighbours_2& out) {
    const std::size_t n = mesh.vertex_bound();
    out.begin.assign(1, 0);
    out.vertex.clear();
    out.hull.clear();
    out.vertex.reserve(6 * n);
    std::vector<std::array<Index, 2>> beside;
    if (mesh.dimension() < 2) beside = neighbours_on_a_line(mesh, x);
    std::vector<Index> ring;
    for (std::size_t v = 0; v < n; ++v) {
        bool hull = mesh.has(static_cast<Index>(v));
        ring.clear();
        if (!beside.empty())
            std::copy_if(beside[v].begin(), beside[v].end(), std::back_inserter(ring),
                         [](Index w) { return w != none; });
        else if (hull) hull = read_ring(mesh.table(), static_cast<Index>(v), ring);
        out.vertex.insert(out.vertex.end(), ring.begin(), ring.end());
        out.begin.push_back(static_cast<Index>(out.vertex.size()));
        out.hull.push_back(hull ? 1 : 0);
    }
}

}  // namespace annulus::inline v1
