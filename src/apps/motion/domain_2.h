// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/cell_2.h>
#include <apps/motion/density_2.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A bounded convex 2D region with non-empty interior: a disc around (0, 0) or a convex polygon. Immutable.
///
/// Lengths are in the caller's unit and must lie between 1e-100 and 1e100, so that squares neither overflow nor vanish.
/// Every factory throws Error(bad_input) when the numbers do not describe such a region.
class Domain_2 {
  public:
    enum class Kind { disc, polygon };
    struct Box {
        Coordinates<2> lower, upper;
    };

    /// The closed disc of `radius` around (0, 0).
    [[nodiscard]] static Domain_2 disc(double radius);
    /// The square [-half_side, half_side]^2, a polygon.
    [[nodiscard]] static Domain_2 square(double half_side);
    /// The convex polygon with these corners, in order, either way round, the first one again at the end or not: see
    /// `convex_ring`, which says what is dropped and throws Corner_error, an Error(bad_input) with the index of the
    /// corner. The same bits for every such list of the same polygon. O(corners).
    [[nodiscard]] static Domain_2 polygon(std::span<const Coordinates<2>> corners);
    /// The convex hull of points, not all on a line; every point is in it (see `contains`). O(n log n).
    [[nodiscard]] static Domain_2 convex_hull_of(std::span<const Coordinates<2>> points);

    [[nodiscard]] Kind kind() const { return kind_; }
    /// Radius of a disc; 0 for a polygon.
    [[nodiscard]] double radius() const { return radius_; }
    /// Corners of a polygon, counter-clockwise; none for a disc.
    [[nodiscard]] std::span<const Coordinates<2>> corners() const { return corners_; }
    /// `edges()[i]` has the polygon's edge from corner i, as a unit outward normal and the bound from (0, 0).
    [[nodiscard]] std::span<const Half_plane_2> edges() const { return edges_; }

    /// Is p in the domain, or no farther out than `tolerance()`? O(1) well inside, O(corners) near the border.
    [[nodiscard]] bool contains(const Coordinates<2>& p) const { return deeper_than(p, -tolerance()); }
    /// Is p inside by more than the rounding of this test? True means inside; false may be wrong within 2 tolerance().
    [[nodiscard]] bool well_contains(const Coordinates<2>& p) const { return deeper_than(p, tolerance()); }
    /// 1e-14 times the greatest distance of the domain from (0, 0): above the rounding of coordinates in the domain.
    [[nodiscard]] double tolerance() const { return 1e-14 * extent_.r_max; }

    [[nodiscard]] double area() const { return area_; }
    [[nodiscard]] const Box& bounding_box() const { return box_; }
    [[nodiscard]] const Extent_2& extent() const { return extent_; }

    /// Cuts a straight-edged convex cell to the domain; no corners are left when they do not meet. `scratch` is work
    /// space. O(corners of the cell), times those of the domain for a polygon.
    void clip(Cell_2& cell, std::vector<Corner_2>& scratch) const;
    /// The whole domain as a cell with that origin.
    [[nodiscard]] Cell_2 whole(const Coordinates<2>& origin) const;

  private:
    Domain_2() = default;
    [[nodiscard]] bool deeper_than(const Coordinates<2>& p, double depth) const {
        const double x = p[0] - middle_[0], y = p[1] - middle_[1], shallow = inner_ - depth;
        // For a disc this is the whole test; tolerance() is above its rounding.
        if (shallow > 0 && x * x + y * y <= shallow * shallow) return true;
        return kind_ == Kind::polygon && deeper_than_edges(p, depth);
    }
    [[nodiscard]] bool deeper_than_edges(const Coordinates<2>& p, double depth) const;

    Kind kind_ = Kind::disc;
    double radius_ = 0;
    std::vector<Coordinates<2>> corners_;
    std::vector<Half_plane_2> edges_;
    Coordinates<2> middle_{};  ///< centre of a disc inside the domain, the short cut of `contains`
    double inner_ = 0;         ///< its radius
    double area_ = 0;
    Box box_{};
    Extent_2 extent_;
};

/// Throws Error(usage) unless the density suits the domain: for an Image_density a polygon inside the image's
/// rectangle, for a Placed_image a polygon.
void require_density(const Density_2& density, const Domain_2& domain);

}  // namespace annulus::inline v1
