// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"
#include "random.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace bench {

/// The families of points, each with the surface on which its points stay while they walk.
///
/// uniform: in the unit cube. sphere: on the unit sphere, all near-cospherical. slab: a hundredth as thick as wide.
/// clusters: over six decades of scale, their points at the scale of the cluster. faces: on the faces of a cube.
/// lattice: a regular grid with noise of an ulp. ball: in the unit ball. In 2D the same with a circle, a strip, the
/// sides of a square, a disc.
inline constexpr std::string_view families[] = {"uniform", "sphere", "slab", "clusters", "faces", "lattice", "ball"};

/// More families. jittered: a regular grid in the unit cube with noise of at most a fifth of a spacing. integers: a
/// regular grid with integers as coordinates, where the corners of every cube are exactly cospherical.
inline constexpr std::string_view lattices[] = {"jittered", "integers"};

/// Families that are hard on an order of insertion or on stars. outliers: in the unit cube, but one in a hundred far
/// away, by Gaussians of 1,000. hubs: eight vertices, and around each as many at a distance of 1 with noise of 1e-3,
/// most of them its neighbours.
inline constexpr std::string_view irregular[] = {"outliers", "hubs"};

/// How points move. walk: every coordinate by independent Gaussians at every step. drift: all by the same, a Gaussian
/// each step. shear: x += s spacings times y. few: one point in a hundred walks. burst: points rest, and at each eighth
/// step walk by eight times as much.
inline constexpr std::string_view kinds_of_motion[] = {"walk", "drift", "shear", "few", "burst"};

/// A family in motion. Positions are in the unit of the family, displacements in spacings n^(-1/d), or the family's own
/// (2 / sqrt n on the unit sphere).
template <int d>
class Scene : public Motion<d> {
  public:
    Scene(std::string_view family, std::string_view motion, std::size_t n, double spacings, std::uint64_t seed);

  private:
    using Motion<d>::x_;
    bool advance() override;
    void walk(std::size_t i, double reach);
    void keep(std::size_t i);

    std::string_view family_;
    std::string_view motion_;
    double reach_;  // of a step, in the unit of the family
    Random random_;
    std::vector<double> scale_;  // by point, of its family's spacing
    std::vector<int> face_;      // by point, 2 * axis + side
    std::uint64_t steps_ = 0;
};

extern template class Scene<2>;
extern template class Scene<3>;

}  // namespace bench
