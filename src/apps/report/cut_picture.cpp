// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/cut_picture.h>

#include <apps/motion/cell_quality.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// The corners of a polygon with these sides, which are in no order, one after the other.
std::vector<Index> chained(std::vector<std::array<Index, 2>> sides) {
    std::vector<Index> corners{sides.back()[0]};
    Index end = sides.back()[1];
    sides.pop_back();
    while (!sides.empty()) {
        const auto next = std::find_if(sides.begin(), sides.end(),
                                       [&](const auto& side) { return side[0] == end || side[1] == end; });
        if (next == sides.end()) break;
        corners.push_back(end);
        end = (*next)[0] == end ? (*next)[1] : (*next)[0];
        sides.erase(next);
    }
    return corners;
}

}  // namespace

Picture cut_picture(const Mesh_cells<3>& cells, std::span<const char> inside, std::span<const Coordinates<3>> position,
                    std::size_t axis, double at, std::string caption, bool filled) {
    Picture picture;
    picture.caption = std::move(caption);
    picture.shading = Shading::angles;
    picture.dots = Dots::crossings;
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
        std::vector<std::array<Index, 2>> sides;
        for (const auto& f : facet_corners) {
            // The section of a facet is a segment between those two of its edges that cross the plane.
            std::array<Index, 2> ends{};
            std::size_t found = 0;
            for (std::size_t i = 0; i < 3; ++i) {
                const Index a = cells.vertices[c][f[i]], b = cells.vertices[c][f[(i + 1) % 3]];
                if (above(a) != above(b)) ends[found++] = point(a, b);
            }
            if (found == 2) sides.push_back({std::min(ends[0], ends[1]), std::max(ends[0], ends[1])});
        }
        edges.insert(sides.begin(), sides.end());
        if (!filled || sides.empty()) continue;
        const auto x = [&](std::size_t k) -> const Coordinates<3>& {
            return position[static_cast<std::size_t>(cells.vertices[c][k])];
        };
        Face face{{}, shade_of_angle(cell_quality(x(0), x(1), x(2), x(3)).dihedral_min)};
        for (const Index i : chained(std::move(sides)))
            face.corners.push_back(picture.points[static_cast<std::size_t>(i)]);
        picture.faces.push_back(std::move(face));
    }
    picture.edges.assign(edges.begin(), edges.end());
    return picture;
}

}  // namespace annulus::inline v1
