// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/feature_curves.h>

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Natural ODT on the sharp edges of a surface: the target of a vertex on a curve is the mean of the midpoints of the
/// two pieces of the curve beside it, weighted with their lengths, which is the middle between its neighbours; a corner
/// stays.
class Curve_motion {
  public:
    /// No sharp edges.
    Curve_motion() = default;
    /// `places` as Feature_curves::places gives them, for each vertex.
    Curve_motion(std::shared_ptr<const Feature_curves> features, std::vector<Feature_curves::Place> places);

    struct Target_on_curve {
        Index vertex, curve;
        double at, wanted;  ///< along the curve
    };
    /// Whether a vertex is a corner or on a curve.
    [[nodiscard]] bool holds(std::size_t v) const {
        return !places_.empty() && places_[v] != Feature_curves::Place::off;
    }
    [[nodiscard]] bool is_corner(std::size_t v) const {
        return !places_.empty() && places_[v] == Feature_curves::Place::corner;
    }
    /// The targets of the vertices on curves; each vertex is on its curve up to rounding. O(k log k) for k of them,
    /// plus searches of their curves.
    [[nodiscard]] std::vector<Target_on_curve> wishes(std::span<const Coordinates<3>> position) const;
    /// The position after this fraction of the way from `at` towards `wanted`, but no farther than `most`.
    [[nodiscard]] Coordinates<3> place(const Target_on_curve& target, double share, double most) const;

  private:
    std::shared_ptr<const Feature_curves> features_;
    std::vector<Feature_curves::Place> places_;
    std::vector<std::vector<Index>> vertices_;  ///< by curve
};

}  // namespace annulus::inline v1
