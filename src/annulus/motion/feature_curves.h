// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/polyline_3.h>
#include <annulus/motion/triangle_surface.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus {

/// The sharp edges of a surface, joined to curves that run from corner to corner, or around.
///
/// An edge is sharp when the planes of its two triangles depart from each other by more than an angle: ridges and
/// valleys alike. A corner is a vertex with sharp edges in which not two of them meet, or two whose directions depart
/// by more than that angle.
class Feature_curves {
  public:
    /// Where a vertex belongs: to a curve, by its number; to a corner; or it is off them.
    enum class Place : Index { off = -1, corner = -2 };

    /// Precondition: every edge is in two triangles that have area. Throws Error(usage) unless 0 < degrees < 180. O(n
    /// log n).
    Feature_curves(const Triangle_surface& surface, double degrees);

    [[nodiscard]] const std::vector<Polyline_3>& curves() const { return curves_; }
    /// Whether a curve has no corner. One that has may end where it begins.
    [[nodiscard]] bool goes_around(std::size_t curve) const { return curve >= between_corners_; }
    [[nodiscard]] const std::vector<Coordinates<3>>& corners() const { return corners_; }
    /// For each point the corner or curve that is at most so far away; corners come first, then the curve with the
    /// least number. O(n log n), and the points in boxes around curves.
    [[nodiscard]] std::vector<Place> places(std::span<const Coordinates<3>> points, double distance) const;
    /// Moves those that have a place on a curve onto it, without rounding across an edge along an axis.
    void recompute_tolerances(std::span<Coordinates<3>> points, double distance) const;

  private:
    std::vector<Polyline_3> curves_;  ///< those between corners come first
    std::size_t between_corners_ = 0;
    std::vector<Coordinates<3>> corners_;
};

}  // namespace annulus
