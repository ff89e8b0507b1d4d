// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/relocation/move_report.h>
#include <annulus/relocation/options.h>
#include <annulus/triangulation/audit.h>
#include <annulus/triangulation/measures.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus {

/// CGAL's Delaunay triangulation of moving points of space, built from scratch at every step: the baseline, with those
/// members of Moving_delaunay that a run needs. It keeps no tolerances and measures none.
class Rebuilt_delaunay_3 {
  public:
    static constexpr int dimension_of_space = 3;

    /// Throws Error(usage) unless the strategy is `rebuild`, not_finite, out_of_domain, collision, too_few (4).
    explicit Rebuilt_delaunay_3(std::span<const Coordinates<3>> points, const Options& options);

    Move_report move_all(std::span<const Coordinates<3>> points);
    Move_report settle() { return {}; }
    [[nodiscard]] std::size_t number_of_vertices() const { return points_.size(); }
    [[nodiscard]] std::span<const Coordinates<3>> positions() const { return points_; }
    [[nodiscard]] Measures measure() const { return {}; }
    /// The verdict of CGAL's exact predicates: every cell positive, no vertex inside the sphere of an adjacent cell, no
    /// vertex beyond a facet of the hull. Not independent of CGAL.
    [[nodiscard]] Audit_result audit() const;
    [[nodiscard]] Audit_input<3> audit_input() const { return {points_, cells_}; }

  private:
    void build();

    std::vector<Coordinates<3>> points_;
    std::vector<std::array<Index, 4>> cells_;
};

}  // namespace annulus
