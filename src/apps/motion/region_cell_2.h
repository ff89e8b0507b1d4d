// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/cell_2.h>
#include <apps/motion/density_2.h>
#include <apps/motion/moments_2.h>
#include <apps/motion/region_2.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Cuts convex cells to a region that is not convex. Use one object per thread: it holds the work space, and allocates
/// only while that grows. The region must outlive it.
class Region_cell_2 {
  public:
    /// Precondition: the region is not convex.
    explicit Region_cell_2(const Region_2& region) : region_(&region) {}

    /// The intersection of a straight-edged convex cell and the region: convex parts with disjoint interiors, each with
    /// an origin in it. The whole cell, with its own origin, if no edge of the region comes near it; else a part for
    /// each triangle of the region that it meets. Corners have an error of a few roundings of the cell's size, those on
    /// edges of triangles also of a few roundings of the region's. O(log n) expected, and linear in the number of
    /// triangles whose bounding rectangles meet that of the cell. The result is valid until the next call.
    std::span<const Cell_2> operator()(const Cell_2& cell);

  private:
    void cut(const Cell_2& cell, const Triangle_2& triangle);

    const Region_2* region_;
    std::vector<Cell_2> part_;
    std::size_t count_ = 0;
    std::vector<std::size_t> near_;
    std::vector<Corner_2> scratch_;
};

/// The moments of parts together; the first moments about `origin`. The errors are those of `moments` for each part.
[[nodiscard]] Moments_2 moments(const Density_2& density, const Coordinates<2>& origin, std::span<const Cell_2> parts);

/// The point of the parts that is nearest to p, moved by 2^-10 of the way to the mean of the corners of its part: so it
/// is in the interior, and points of disjoint parts differ. Parts of less than 2^-30 of the area of all are rounding
/// and do not count. Precondition: the parts have an area.
[[nodiscard]] Coordinates<2> nearest_inside(std::span<const Cell_2> parts, const Coordinates<2>& p);

}  // namespace annulus::inline v1
