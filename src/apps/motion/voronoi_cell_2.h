// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/neighbours.h>
#include <apps/motion/cell_2.h>
#include <apps/motion/domain_2.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Computes Voronoi cells cut to a domain from Delaunay neighbours. Use one object per thread: it holds the work space,
/// and allocates only while that grows. The domain must outlive it.
class Voronoi_cell_2 {
  public:
    explicit Voronoi_cell_2(const Domain_2& domain) : domain_(&domain) {}

    /// The cell of `site` in the domain: the part not farther from `site` than from any neighbour's position. When
    /// `cyclic`, consecutive neighbours (and last, first) make Delaunay triangles with the site, counter-clockwise.
    ///
    /// A cyclic list whose circumcentres are all in the domain gives the cell directly, O(neighbours). When one is not,
    /// when a triangle is nearly flat (the circumcentre would be noise), or when the result is not counter-clockwise
    /// around the site (so the list was no Delaunay star), the domain is cut by all bisectors, O(neighbours^2): this is
    /// correct for any order of the list, and without neighbours the cell is the whole domain. Corners have an error of
    /// a few roundings of the cell's size, over the sine of the angle between the lines that meet there; corners on the
    /// border of the domain also of a few roundings of the domain's size. The origin is the site if the domain contains
    /// it, else a point of the cell. The result is valid until the next call.
    const Cell_2& operator()(const Coordinates<2>& site, std::span<const Index> neighbours,
                             std::span<const Coordinates<2>> position, bool cyclic);

    /// Whether the corners of the last cell are circumcentres well inside the domain, and its area is more than 1e-6 of
    /// the greatest square of a corner's offset. Its centroid is then in it, under any density, and in the domain, by
    /// far more than rounding.
    [[nodiscard]] bool plump() const { return plump_; }

  private:
    bool from_circumcentres(const Coordinates<2>& site, std::span<const Index> neighbours,
                            std::span<const Coordinates<2>> position);
    void from_bisectors(const Coordinates<2>& site, std::span<const Index> neighbours,
                        std::span<const Coordinates<2>> position);

    const Domain_2* domain_;
    Cell_2 cell_;
    bool plump_ = false;
    Clipper_2 clipper_;
    std::vector<Corner_2> scratch_;
    std::vector<Coordinates<2>> start_corners_;
    std::vector<Half_plane_2> start_lines_;
};

}  // namespace annulus::inline v1
