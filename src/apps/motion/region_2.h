// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/domain_2.h>
#include <apps/motion/triangles_2.h>

#include <cstddef>
#include <memory>
#include <span>
#include <utility>

namespace annulus::inline v1 {

/// A bounded 2D region with non-empty interior: a convex Domain_2, or a polygon that need not be convex, in one piece
/// or several, with or without holes. Immutable; copies share their triangles. Lengths as for Domain_2.
class Region_2 {
  public:
    /// A convex region: a conversion, since every Domain_2 is one.
    Region_2(Domain_2 domain) : hull_(std::move(domain)), area_(hull_.area()) {}
    /// The polygon of one ring or several; what an odd number of rings encloses belongs to it, so that the order of the
    /// rings and their directions do not matter. The arguments, and what is thrown, are those of `polygon_edges`. One
    /// ring that is convex up to rounding, as `convex_ring` says, gives Domain_2::polygon of it, which is convex. The
    /// same bits for every list of the same rings. O(n log^2 n) expected.
    [[nodiscard]] static Region_2 polygon(std::span<const Coordinates<2>> corners, std::span<const std::size_t> begin);

    [[nodiscard]] bool convex() const { return triangles_ == nullptr; }
    /// The region itself if it is convex; else its convex hull.
    [[nodiscard]] const Domain_2& hull() const { return hull_; }
    /// The triangles of a region that is not convex. Precondition: not convex().
    [[nodiscard]] const Triangles_2& triangles() const { return *triangles_; }

    /// Is p in the region, or no farther out than `tolerance()`? As Domain_2, or O(log corners) expected.
    [[nodiscard]] bool contains(const Coordinates<2>& p) const {
        return hull_.contains(p) && (convex() || triangles_->contains(p) ||
                                     triangles_->edge_at(p, tolerance()) < triangles_->edges().size());
    }
    [[nodiscard]] double tolerance() const { return hull_.tolerance(); }
    [[nodiscard]] double area() const { return area_; }
    [[nodiscard]] const Domain_2::Box& bounding_box() const { return hull_.bounding_box(); }

  private:
    Region_2(Domain_2 hull, std::shared_ptr<const Triangles_2> triangles);

    Domain_2 hull_;
    double area_;
    std::shared_ptr<const Triangles_2> triangles_;
};

}  // namespace annulus::inline v1
