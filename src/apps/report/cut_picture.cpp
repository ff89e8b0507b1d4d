// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/cut_picture.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace annulus::inline v1 {

Picture cut_picture(const Mesh_cells<3>& cells, std::span<const char> inside, std::span<const Coordinates<3>> position,
                    std::size_t axis, double at, std::string caption) {
    Picture picture;
    picture.caption = std::move(caption);
    const std::size_t right = axis == 0 ? 1 : 0, up = axis == 2 ? 1 : 2;
    const auto above = [&](Index v) { return position[static_cast<std::size_t>(v)][axis] >= at; };
    std::map<std::array<Index, 2>, Index> on_edge;
    const auto point = [&](Index a, Index b) {
        if (a > b) std::swap(a, b);
        const auto [found, is_new] = on_edge.emplace(std::array{a, b}, static_cast<Index>(picture.points.size()));
        if (is_new) {
            const auto &p = position[static_cast<std::size_t>(a)], &q = position[static_cast<std::size_t>(b)];
            const double t = (at - p[axis]) / (q[axis] - p[axis]);
            picture.points.push_back({p[right] + t * (q[right] - p[right]), p[up] + t * (q[up] - p[up])});
        }
        return found->second;
    };
    std::set<std::array<Index, 2>> edges;
    for (std::size_t c = 0; c < cells.vertices.size(); ++c) {
        if (inside[c] == 0) continue;
        for (const auto& f : facet_corners) {
            // The section of a facet is a segment between those two of its edges that cross the plane.
            std::array<Index, 2> ends{};
            std::size_t found = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const Index a = cells.vertices[c][f[i]], b = cells.vertices[c][f[(i + 1) % 3]];
                if (above(a) != above(b)) ends[found++] = point(a, b);
            }
            if (found == 2) edges.insert({std::min(ends[0], ends[1]), std::max(ends[0], ends[1])});
        }
    }
    picture.edges.assign(edges.begin(), edges.end());
    return picture;
}

}  // namespace annulus::inline v1
