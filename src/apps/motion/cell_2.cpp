// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/cell_2.h>

#include <apps/motion/vector_2.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace annulus::inline v1 {

double angle_spanned(const Coordinates<2>& p, const Coordinates<2>& d) {
    // cross(p, p + d) = cross(p, d) without the cancellation.
    return std::atan2(cross(p, d), dot(p, p) + dot(p, d));
}

double arc_span(const Coordinates<2>& origin, const Coordinates<2>& from, const Coordinates<2>& to) {
    const double angle = angle_spanned(plus(origin, from), minus(to, from));
    if (angle >= 0) return angle;
    return angle > -1e-9 ? 0 : angle + 2 * std::numbers::pi;
}

void assign_disc(const Coordinates<2>& origin, double radius, std::vector<Corner_2>& corners) {
    corners.clear();
    for (const Coordinates<2>& p :
         {Coordinates<2>{radius, 0}, Coordinates<2>{0, radius}, Coordinates<2>{-radius, 0}, Coordinates<2>{0, -radius}})
        corners.push_back({minus(p, origin), true});
}

void clip_to_disc(Cell_2& cell, double radius, std::vector<Corner_2>& scratch) {
    const std::size_t n = cell.corners.size();
    if (n < 3) return cell.corners.clear();
    const auto inside = [&](const Coordinates<2>& p) { return dot(p, p) <= radius * radius; };
    scratch.clear();
    bool disc_in_polygon = true;  // (0, 0) is left of every edge
    for (std::size_t i = 0; i < n; ++i) {
        const Coordinates<2>& a = cell.corners[i].offset;
        const Coordinates<2>& b = cell.corners[i + 1 < n ? i + 1 : 0].offset;
        const Coordinates<2> p = plus(cell.origin, a), d = minus(b, a);
        const bool in_a = inside(p), in_b = inside(plus(cell.origin, b));
        const double turn = cross(p, d), length2 = dot(d, d);
        if (turn < 0) disc_in_polygon = false;
        if (in_a && in_b) {
            scratch.push_back({a, false});
            continue;
        }
        if (!(length2 > 0)) continue;
        // The chord of the edge's line is the middle parameter -+ half. Each corner is judged once, by `inside`, so
        // that an edge that leaves at a corner and the edge that enters there can never disagree.
        const double room = radius * radius - turn * (turn / length2);
        const double middle = -dot(p, d) / length2;
        if (!in_a && !in_b && (!(room > 0) || middle <= 0 || middle >= 1)) continue;
        const double half = std::sqrt(std::max(room, 0.0) / length2);
        const double t0 = in_a ? 0 : std::clamp(middle - half, 0.0, 1.0);
        const double t1 = in_b ? 1 : std::clamp(middle + half, 0.0, 1.0);
        scratch.push_back({in_a ? a : Coordinates<2>{a[0] + t0 * d[0], a[1] + t0 * d[1]}, false});
        if (!in_b) scratch.push_back({{a[0] + t1 * d[0], a[1] + t1 * d[1]}, true});
    }
    if (scratch.empty() && disc_in_polygon) return assign_disc(cell.origin, radius, cell.corners);
    cell.corners.swap(scratch);
}

void Clipper_2::start(std::span<const Coordinates<2>> corners, std::span<const Half_plane_2> lines) {
    line_.assign(lines.begin(), lines.end());
    corner_.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) corner_.push_back({corners[i], i, 0});
}

void Clipper_2::clip(const Half_plane_2& half_plane) {
    bool any_out = false, any_in = false;
    for (Tagged& corner : corner_) {
        corner.height = dot(half_plane.normal, corner.offset) - half_plane.bound;
        (corner.height > 0 ? any_out : any_in) = true;
    }
    if (!any_out) return;
    if (!any_in) return corner_.clear();
    const std::size_t line = line_.size();
    line_.push_back(half_plane);
    next_.clear();
    for (std::size_t i = 0; i < corner_.size(); ++i) {
        const Tagged& a = corner_[i];
        const Tagged& b = corner_[i + 1 < corner_.size() ? i + 1 : 0];
        if (a.height <= 0) next_.push_back(a);
        if ((a.height > 0) == (b.height > 0)) continue;
        const double t = a.height / (a.height - b.height);
        const Coordinates<2> d = minus(b.offset, a.offset);
        // Going out, the next edge is on the new line; coming in, it is the rest of this edge.
        next_.push_back({{a.offset[0] + t * d[0], a.offset[1] + t * d[1]}, a.height <= 0 ? line : a.line, 0});
    }
    corner_.swap(next_);
}

void Clipper_2::write_corners(std::vector<Corner_2>& corners) const {
    corners.clear();
    if (empty()) return;
    for (std::size_t i = 0; i < corner_.size(); ++i) {
        const Half_plane_2& before = line_[corner_[i > 0 ? i - 1 : corner_.size() - 1].line];
        const Half_plane_2& after = line_[corner_[i].line];
        const double turn = cross(before.normal, after.normal);
        Coordinates<2> offset = corner_[i].offset;
        // Two nearly parallel lines have no well-defined intersection: the clipped corner is better there.
        if (turn * turn > 1e-12 * dot(before.normal, before.normal) * dot(after.normal, after.normal))
            offset = {(before.bound * after.normal[1] - after.bound * before.normal[1]) / turn,
                      (after.bound * before.normal[0] - before.bound * after.normal[0]) / turn};
        corners.push_back({offset, false});
    }
}

}  // namespace annulus::inline v1
