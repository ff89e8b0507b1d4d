// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <apps/motion/generated_points.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// How points of the unit square or cube move.
enum class Motion_family {
    walk,   ///< each coordinate by its own random number at every step
    shear,  ///< x grows with y: layers slide over each other
    orbit,  ///< each point circles around its own centre, half a spacing away, every other one backwards
};
inline constexpr std::array<std::pair<std::string_view, Motion_family>, 3> motion_families{
    {{"walk", Motion_family::walk}, {"shear", Motion_family::shear}, {"orbit", Motion_family::orbit}}};

/// A motion of points. The spacing is that of a grid of as many points in the square or cube; in a periodic box the
/// d-th root of the volume per point.
template <int d>
class Generated_motion {
  public:
    /// `pace`: how far points move in a step, in spacings: the standard deviation of a coordinate of a walk, the
    /// displacement of a point at y = 1 in a shear, the displacement of each point along its orbit where that is small.
    Generated_motion(std::vector<Coordinates<d>> points, Motion_family family, double pace, std::uint64_t seed);
    /// In a periodic box, whose sides points cross. A shear takes the box along: at a height of the d-th root of its
    /// volume the displacement is `pace` spacings, and long vectors are replaced by shorter ones of the same lattice.
    Generated_motion(const Box<d>& box, std::vector<Coordinates<d>> points, Motion_family family, double pace,
                     std::uint64_t seed);

    [[nodiscard]] std::span<const Coordinates<d>> points() const { return points_; }
    /// That of the points now; none where boundaries are open.
    [[nodiscard]] const std::optional<Box<d>>& box() const { return box_; }
    /// Advances to the next time step.
    void step();

  private:
    void start_orbits();
    void shear();
    void orbit();

    std::optional<Box<d>> box_;
    std::vector<Coordinates<d>> points_;
    Motion_family family_;
    double spacing_, pace_;
    Portable_random random_;
    std::vector<Coordinates<2>> arm_;  ///< of an orbit: from its centre to its point
};

extern template class Generated_motion<2>;
extern template class Generated_motion<3>;

}  // namespace annulus::inline v1
