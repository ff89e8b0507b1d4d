// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <array>
#include <cstddef>
#include <vector>

namespace annulus {

/// A curve of straight segments, with its places told apart by how far along it they are, in the caller's unit of
/// length.
class Polyline_3 {
  public:
    /// At least two points, neighbours differ. Where the first is the last the curve is closed. O(points).
    explicit Polyline_3(std::vector<Coordinates<3>> points);

    [[nodiscard]] const std::vector<Coordinates<3>>& points() const { return points_; }
    [[nodiscard]] bool closed() const { return points_.front() == points_.back(); }
    [[nodiscard]] double length() const { return up_to_.back(); }
    /// Where one is after so long a way from the first point, on a segment up to rounding; a coordinate that both its
    /// ends share is kept exactly. Ways beyond the ends go to the ends, or around where the curve is closed. O(log
    /// points).
    [[nodiscard]] Coordinates<3> at(double way) const;
    /// How far along the point nearest to p is; the first of several. O(points / 32) where the curve is not wound up.
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

}  // namespace annulus
