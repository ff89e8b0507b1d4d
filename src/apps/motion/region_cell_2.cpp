// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/region_cell_2.h>

#include <apps/motion/vector_2.h>

#include <algorithm>
#include <limits>

namespace annulus::inline v1 {

namespace {

Coordinates<2> mean_offset(const Cell_2& cell) {
    Coordinates<2> mean{};
    for (const Corner_2& corner : cell.corners)
        for (std::size_t k = 0; k < 2; ++k) mean[k] += corner.offset[k] / static_cast<double>(cell.corners.size());
    return mean;
}

Rectangle_2 box_around(const Cell_2& cell) {
    Rectangle_2 box{plus(cell.origin, cell.corners[0].offset), plus(cell.origin, cell.corners[0].offset)};
    for (const Corner_2& corner : cell.corners) {
        const Coordinates<2> p = plus(cell.origin, corner.offset);
        for (std::size_t k = 0; k < 2; ++k) {
            box.lower[k] = std::min(box.lower[k], p[k]);
            box.upper[k] = std::max(box.upper[k], p[k]);
        }
    }
    return box;
}

/// Cuts to the side normal . u <= bound. Corners are those of the polygon, or lie on its edges.
void clip(std::vector<Corner_2>& corners, const Half_plane_2& side, std::vector<Corner_2>& next) {
    next.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Coordinates<2>& a = corners[i].offset;
        const Coordinates<2>& b = corners[i + 1 < corners.size() ? i + 1 : 0].offset;
        const double at_a = dot(side.normal, a) - side.bound, at_b = dot(side.normal, b) - side.bound;
        if (at_a <= 0) next.push_back({a, false});
        if ((at_a > 0) == (at_b > 0)) continue;
        const double t = at_a / (at_a - at_b);
        next.push_back({{a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])}, false});
    }
    corners.swap(next);
}

double area_of(const Cell_2& cell) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < cell.corners.size(); ++i)
        twice += cross(minus(cell.corners[i].offset, cell.corners[0].offset),
                       minus(cell.corners[i + 1].offset, cell.corners[0].offset));
    return twice / 2;
}

/// The point of a convex cell that is nearest to p.
Coordinates<2> nearest_in(const Cell_2& cell, const Coordinates<2>& p) {
    const std::size_t n = cell.corners.size();
    bool inside = true;
    double least = std::numeric_limits<double>::infinity();
    Coordinates<2> nearest = p;
    for (std::size_t i = 0; i < n; ++i) {
        const Coordinates<2> a = plus(cell.origin, cell.corners[i].offset),
                             b = plus(cell.origin, cell.corners[i + 1 < n ? i + 1 : 0].offset);
        if (a == b) continue;
        inside = inside && cross(minus(b, a), minus(p, a)) >= 0;
        const Coordinates<2> q = nearest_on({a, b}, p);
        const double far = norm(minus(q, p));
        if (far < least) least = far, nearest = q;
    }
    return inside ? p : nearest;
}

}  // namespace

void Region_cell_2::cut(const Cell_2& cell, const Triangle_2& triangle) {
    if (part_.size() == count_) part_.emplace_back();
    Cell_2& part = part_[count_];
    part.corners.assign(cell.corners.begin(), cell.corners.end());
    for (const Half_plane_2& side : triangle.side)
        clip(part.corners, {side.normal, side.bound - dot(side.normal, cell.origin)}, scratch_);
    if (part.corners.size() < 3) return;
    const Coordinates<2> mean = mean_offset(part);
    part.origin = plus(cell.origin, mean);
    const Coordinates<2> shift = minus(part.origin, cell.origin);  // as rounded
    for (Corner_2& corner : part.corners) corner.offset = minus(corner.offset, shift);
    if (area_of(part) > 0) ++count_;
}

std::span<const Cell_2> Region_cell_2::operator()(const Cell_2& cell) {
    count_ = 0;
    if (cell.corners.size() < 3) return {};
    const Triangles_2& triangles = region_->triangles();
    const Rectangle_2 box = box_around(cell);
    if (triangles.edge_near(box, region_->tolerance())) {
        triangles.near(box, near_);
        for (const std::size_t t : near_) cut(cell, triangles.all()[t]);
    } else if (triangles.contains(plus(cell.origin, mean_offset(cell)))) {
        if (part_.empty()) part_.emplace_back();
        part_[count_++] = cell;
    }
    return {part_.data(), count_};
}

Moments_2 moments(const Density_2& density, const Coordinates<2>& origin, std::span<const Cell_2> parts) {
    Moments_2 sum;
    for (const Cell_2& part : parts) {
        const Moments_2 m = moments(density, part.origin, part.corners);
        const Coordinates<2> shift = minus(part.origin, origin);
        sum.mass += m.mass;
        for (std::size_t k = 0; k < 2; ++k) sum.first[k] += m.first[k] + m.mass * shift[k];
    }
    return sum;
}

Coordinates<2> nearest_inside(std::span<const Cell_2> parts, const Coordinates<2>& p) {
    double all = 0, least = std::numeric_limits<double>::infinity();
    for (const Cell_2& part : parts) all += area_of(part);
    Coordinates<2> nearest = p;
    for (const Cell_2& part : parts) {
        if (!(area_of(part) >= 0x1p-30 * all)) continue;
        const Coordinates<2> q = nearest_in(part, p);
        const double far = norm(minus(q, p));
        if (!(far < least)) continue;
        least = far;
        const Coordinates<2> inwards = minus(plus(part.origin, mean_offset(part)), q);
        nearest = {q[0] + 0x1p-10 * inwards[0], q[1] + 0x1p-10 * inwards[1]};
    }
    return nearest;
}

}  // namespace annulus::inline v1
