// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <vector>

namespace annulus::inline v1 {

/// A curve of straight segments, whose points are given by their distance along it, in the caller's unit of length.
class Polyline_3 {
  public:
    /// At least two points; consecutive ones differ. The curve is closed where the first point equals the last.
    /// O(points).
    explicit Polyline_3(std::vector<Coordinates<3>> points);

    [[nodiscard]] const std::vector<Coordinates<3>>& points() const { return points_; }
    [[nodiscard]] bool closed() const { return points_.front() == points_.back(); }
    [[nodiscard]] double length() const { return up_to_.back(); }
    /// The point at this distance along the curve from the first point, on a segment up to rounding; a coordinate that
    /// both ends of the segment share is kept exactly. Distances beyond the ends are clamped to the ends, or wrap
    /// around where the curve is closed. O(log points).
    [[nodiscard]] Coordinates<3> at(double way) const;
    /// The distance along the curve of the point nearest to p; the first of several. O(points / 32) where the curve is
    /// not tightly wound.
    [[nodiscard]] double nearest(const Coordinates<3>& p) const;
    /// The box around it.
    [[nodiscard]] const Coordinates<3>& lower() const { return box_.lower; }
    [[nodiscard]] const Coordinates<3>& upper() const { return box_.upper; }

  private:
    struct Box {
        Coordinates<3> lower, upper;
    };
    /// The box around the points from `first` to `last`, both among them.
    [[nodiscard]] Box box_of(std::size_t first, std::size_t last) const;
    static constexpr std::size_t run = 32;  ///< segments in a box

    std::vector<Coordinates<3>> points_;
    std::vector<double> up_to_;  ///< by point
    std::vector<Box> boxes_;     ///< around each run of segments
    Box box_;
};

}  // namespace annulus::inline v1
