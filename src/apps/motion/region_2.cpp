// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/region_2.h>

#include <annulus/error.h>
#include <apps/motion/vector_2.h>

#include <optional>
#include <vector>

namespace annulus::inline v1 {

namespace {

std::optional<Domain_2> convex_polygon(std::span<const Coordinates<2>> corners) {
    try {
        return Domain_2::polygon(corners);
    } catch (const Corner_error&) {
        return {};
    }
}

}  // namespace

Region_2::Region_2(Domain_2 hull, std::shared_ptr<const Triangles_2> triangles)
    : hull_(std::move(hull)), area_(0), triangles_(std::move(triangles)) {
    for (const Triangle_2& t : triangles_->all())
        area_ += cross(minus(t.corner[1], t.corner[0]), minus(t.corner[2], t.corner[0])) / 2;
    if (!(area_ > 0)) throw Error(Error_code::bad_input, "a polygon must have an area that is not lost in rounding");
}

Region_2 Region_2::polygon(std::span<const Coordinates<2>> corners, std::span<const std::size_t> begin) {
    if (begin.size() == 1)
        if (auto domain = convex_polygon(corners)) return *std::move(domain);
    const Polygon_edges_2 edges = polygon_edges(corners, begin);
    return {Domain_2::convex_hull_of(edges.corner), std::make_shared<const Triangles_2>(edges)};
}

}  // namespace annulus::inline v1
