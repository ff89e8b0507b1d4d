// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/domain_2.h>

#include <annulus/error.h>
#include <apps/motion/convex_ring_2.h>
#include <apps/motion/moments_2.h>
#include <apps/motion/vector_2.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/convex_hull_2.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numbers>
#include <string>

namespace annulus::inline v1 {

namespace {

using Points = std::vector<Coordinates<2>>;

void require(bool fact, const std::string& what) {
    if (!fact) throw Error(Error_code::bad_input, what);
}

void require_length(double length, const std::string& what) {
    require(std::isfinite(length) && length >= 1e-100 && length <= 1e100, what + " must lie between 1e-100 and 1e100");
}

/// Distance from (0, 0) to the segment.
double distance_to_segment(const Coordinates<2>& a, const Coordinates<2>& b) {
    const Coordinates<2> d = minus(b, a);
    const double t = std::clamp(-dot(a, d) / dot(d, d), 0.0, 1.0);
    return norm({a[0] + t * d[0], a[1] + t * d[1]});
}

}  // namespace

Domain_2 Domain_2::disc(double radius) {
    require_length(radius, "the radius of a disc");
    Domain_2 domain;
    domain.kind_ = Kind::disc;
    domain.radius_ = domain.inner_ = radius;
    domain.area_ = std::numbers::pi * radius * radius;
    domain.box_ = {{-radius, -radius}, {radius, radius}};
    domain.extent_ = {0, radius, radius};
    return domain;
}

Domain_2 Domain_2::square(double half_side) {
    require_length(half_side, "the half side of a square");
    const double h = half_side;
    return polygon(Points{{-h, -h}, {h, -h}, {h, h}, {-h, h}});
}

Domain_2 Domain_2::polygon(std::span<const Coordinates<2>> given) {
    Domain_2 domain;
    domain.kind_ = Kind::polygon;
    domain.corners_ = convex_ring(given);
    const Points& corners = domain.corners_;
    const double limit = std::numeric_limits<double>::infinity();
    domain.box_ = {{limit, limit}, {-limit, -limit}};
    domain.extent_ = {limit, 0, 0};
    bool around_zero = true;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Coordinates<2>& a = corners[i];
        const Coordinates<2>& b = corners[(i + 1) % corners.size()];
        const Coordinates<2> d = minus(b, a);
        const Coordinates<2> normal{d[1] / norm(d), -d[0] / norm(d)};
        // The bound from both ends, so that both are on the inner side of it as far as rounding allows.
        domain.edges_.push_back({normal, std::max(dot(normal, a), dot(normal, b))});
        if (domain.edges_.back().bound < 0) around_zero = false;
        for (std::size_t k = 0; k < 2; ++k) {
            domain.box_.lower[k] = std::min(domain.box_.lower[k], a[k]);
            domain.box_.upper[k] = std::max(domain.box_.upper[k], a[k]);
        }
        Extent_2& extent = domain.extent_;
        extent.r_min = std::min(extent.r_min, distance_to_segment(a, b));
        extent.r_max = std::max(extent.r_max, norm(a));
        extent.abs_x_max = std::max(extent.abs_x_max, std::abs(a[0]));
    }
    if (around_zero) domain.extent_.r_min = 0;
    const Cell_2 all = domain.whole(corners[0]);
    const Moments_2 m = moments(Density::one, all.origin, all.corners);
    domain.area_ = m.mass;
    require(m.mass > 0, "a polygon must have an area that is not lost in rounding");
    domain.middle_ = {all.origin[0] + m.first[0] / m.mass, all.origin[1] + m.first[1] / m.mass};
    domain.inner_ = limit;
    for (const Half_plane_2& edge : domain.edges_)
        domain.inner_ = std::min(domain.inner_, edge.bound - dot(edge.normal, domain.middle_));
    domain.inner_ = std::max(domain.inner_, 0.0);
    return domain;
}

Domain_2 Domain_2::convex_hull_of(std::span<const Coordinates<2>> points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_2> all, hull;
    for (const Coordinates<2>& p : points) {
        require(std::isfinite(p[0]) && std::isfinite(p[1]), "a point of a convex hull is not finite");
        all.emplace_back(p[0], p[1]);
    }
    CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(hull));
    require(hull.size() >= 3, "a convex hull needs 3 points that are not on a line");
    Points corners;
    for (const auto& p : hull) corners.push_back({p.x(), p.y()});
    return polygon(corners);
}

bool Domain_2::deeper_than_edges(const Coordinates<2>& p, double depth) const {
    for (const Half_plane_2& edge : edges_)
        if (!(dot(edge.normal, p) + depth <= edge.bound)) return false;
    return true;
}

void Domain_2::clip(Cell_2& cell, std::vector<Corner_2>& scratch) const {
    if (kind_ == Kind::disc) return clip_to_disc(cell, radius_, scratch);
    Clipper_2 clipper;
    Points corners;
    std::vector<Half_plane_2> lines;
    for (std::size_t i = 0; i < cell.corners.size(); ++i) {
        const Coordinates<2>& a = cell.corners[i].offset;
        const Coordinates<2> d = minus(cell.corners[i + 1 < cell.corners.size() ? i + 1 : 0].offset, a);
        corners.push_back(a);
        lines.push_back({{d[1], -d[0]}, d[1] * a[0] - d[0] * a[1]});
    }
    clipper.start(corners, lines);
    for (const Half_plane_2& edge : edges_) clipper.clip({edge.normal, edge.bound - dot(edge.normal, cell.origin)});
    clipper.write_corners(cell.corners);
}

void require_density(const Density_2& density, const Domain_2& domain) {
    if (std::get_if<Placed_image>(&density) != nullptr && domain.kind() != Domain_2::Kind::polygon)
        throw Error(Error_code::usage, "a density that is an array or a function is for polygons, not for a disc");
    const auto* image = std::get_if<Image_density>(&density);
    if (image == nullptr) return;
    const auto& box = domain.bounding_box();
    const auto width = static_cast<double>(image->width()), height = static_cast<double>(image->height());
    if (domain.kind() != Domain_2::Kind::polygon || box.lower[0] < 0 || box.lower[1] < 0 || box.upper[0] > width ||
        box.upper[1] > height)
        throw Error(Error_code::usage, "the density of an image is for a polygon in the image");
}

Cell_2 Domain_2::whole(const Coordinates<2>& origin) const {
    Cell_2 cell{origin, {}};
    if (kind_ == Kind::disc) assign_disc(origin, radius_, cell.corners);
    for (const Coordinates<2>& p : corners_) cell.corners.push_back({minus(p, origin), false});
    return cell;
}

}  // namespace annulus::inline v1
