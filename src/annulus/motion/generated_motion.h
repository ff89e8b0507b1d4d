// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/generated_points.h>

#include <cstdint>
#include <span>
#include <vector>

namespace annulus {

/// Where points of the unit square or cube go.
enum class Motion_family {
    walk,   ///< each coordinate by a random number of its own at every step
    shear,  ///< x grows with y: layers slide over each other
    orbit,  ///< each point circles around a place of its own, half a spacing away, every other one backwards
};
inline constexpr std::array<std::pair<std::string_view, Motion_family>, 3> motion_families{
    {{"walk", Motion_family::walk}, {"shear", Motion_family::shear}, {"orbit", Motion_family::orbit}}};

/// A motion of points. A spacing is that of a grid of as many in the square or cube.
template <int d>
class Generated_motion {
  public:
    /// `pace`: how far points go at a step, in spacings: the standard deviation of a coordinate of a walk, the way of
    /// a point at y = 1 in a shear, the way of each along its orbit for small ones.
    Generated_motion(std::vector<Coordinates<d>> points, Motion_family family, double pace, std::uint64_t seed);

    [[nodiscard]] std::span<const Coordinates<d>> points() const { return points_; }
    /// Goes on to the next time step.
    void step();

  private:
    void orbit();

    std::vector<Coordinates<d>> points_;
    Motion_family family_;
    double spacing_, pace_;
    Portable_random random_;
    std::vector<Coordinates<2>> arm_;  ///< of an orbit: from its centre to its point
};

extern template class Generated_motion<2>;
extern template class Generated_motion<3>;

}  // namespace annulus
