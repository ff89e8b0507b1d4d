// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_polytopes.h>

#include <annulus/error.h>
#include <annulus/measure/voronoi_cut.h>
#include <annulus/mesh/at.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace annulus::inline v1 {

namespace {

std::vector<std::array<Index, 2>> pairs_of(const Vertex_neighbours& neighbours, std::size_t n) {
    std::vector<std::array<Index, 2>> pairs;
    pairs.reserve(neighbours.index.size() / 2);
    for (std::size_t v = 0; v < n; ++v)
        for (const Index j : neighbours.of(static_cast<Index>(v)))
            if (j > static_cast<Index>(v)) pairs.push_back({static_cast<Index>(v), j});
    return pairs;
}

/// The sides of a polygon in order: each begins where the one before it ends.
std::vector<Cell_face> in_order(std::vector<Cell_face> sides) {
    for (std::size_t k = 0; k + 2 < sides.size(); ++k) {
        const auto next = std::find_if(sides.begin() + static_cast<std::ptrdiff_t>(k) + 1, sides.end(),
                                       [&](const Cell_face& side) { return side.corners[0] == sides[k].corners[1]; });
        if (next != sides.end()) std::swap(sides[k + 1], *next);
    }
    return sides;
}

/// Appends the corners and sides of a cell.
template <int d>
void append(Voronoi_polytopes<d>& out, const Voronoi_cut<d>& cut, Index v) {
    const Convex_cell<d> cell = cut.polytope(v);
    if (cell.is_empty()) return;
    const auto others = cut.neighbours(v);
    const std::size_t first = out.corner.size();
    for (const Coordinates<d>& x : cell.corners()) out.corner.push_back(cut.position(v, x));
    for (const Cell_face& side : d == 2 ? in_order(cell.faces()) : cell.faces()) {
        out.neighbour.push_back(side.label < 0 ? -1 : others[at(side.label)]);
        for (const std::size_t c : side.corners) out.side_corner.push_back(static_cast<Index>(first + c));
        out.corner_begin.push_back(static_cast<Index>(out.side_corner.size()));
    }
    if (out.side_corner.size() > static_cast<std::size_t>(std::numeric_limits<Index>::max() / 2))
        throw Error(Error_code::too_large, "the Voronoi cells have more corners than there are indices");
}

}  // namespace

template <int d>
Voronoi_polytopes<d> voronoi_polytopes(std::span<const Coordinates<d>> points, const Vertex_neighbours& neighbours,
                                       const Voronoi_clip<d>& clip) {
    Voronoi_polytopes<d> out;
    out.side_begin.push_back(0);
    out.corner_begin.push_back(0);
    // The cell of the only vertex is the clip, wherever the vertex is.
    const bool alone = neighbours.index.empty();
    Coordinates<d> middle;
    for (std::size_t k = 0; k < d; ++k) middle[k] = 0.5 * clip.lower[k] + 0.5 * clip.upper[k];
    const std::vector<Coordinates<d>> in_middle(alone ? points.size() : 0, middle);
    const Voronoi_cut<d> cut(alone ? std::span(in_middle) : points, pairs_of(neighbours, points.size()), clip);
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (!std::isnan(points[v][0])) append(out, cut, static_cast<Index>(v));
        out.side_begin.push_back(static_cast<Index>(out.neighbour.size()));
    }
    return out;
}

template Voronoi_polytopes<2> voronoi_polytopes<2>(std::span<const Coordinates<2>>, const Vertex_neighbours&,
                                                   const Voronoi_clip<2>&);
template Voronoi_polytopes<3> voronoi_polytopes<3>(std::span<const Coordinates<3>>, const Vertex_neighbours&,
                                                   const Voronoi_clip<3>&);

}  // namespace annulus::inline v1
