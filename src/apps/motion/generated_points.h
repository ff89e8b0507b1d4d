// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <random>
#include <string_view>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Families of points of the unit square or cube.
enum class Point_family {
    uniform,
    grid,         ///< a regular grid, row by row; its last rows may be absent
    jittered,     ///< the same, each coordinate moved by at most a quarter of the grid's spacing
    cospherical,  ///< on one circle or sphere, as well as doubles can
    clusters,     ///< around one centre for each hundred points, with widths over six decades
    surface,      ///< on an ellipse or ellipsoid with axes 1, 0.8, 0.6, as well as doubles can
};
/// Their names, as in the tool.
inline constexpr std::array<std::pair<std::string_view, Point_family>, 6> point_families{
    {{"uniform", Point_family::uniform},
     {"grid", Point_family::grid},
     {"jittered", Point_family::jittered},
     {"cospherical", Point_family::cospherical},
     {"clusters", Point_family::clusters},
     {"surface", Point_family::surface}}};

/// The element with that name of a list like `point_families`.
template <class Family, std::size_t n>
[[nodiscard]] std::optional<Family> family_named(const std::array<std::pair<std::string_view, Family>, n>& families,
                                                 std::string_view name) {
    for (const auto& family : families)
        if (family.first == name) return family.second;
    return std::nullopt;
}

/// The same numbers for a seed on every platform with IEEE doubles: only arithmetic and square roots are used.
class Portable_random {
  public:
    explicit Portable_random(std::uint64_t seed) : bits_(seed) {}

    /// In [0, 1), a multiple of 2^-53.
    double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
    /// A number of mean 0 and variance 1, between -3.5 and 3.5: the sum of four uniform ones.
    double bell();
    std::size_t below(std::size_t n) { return static_cast<std::size_t>(bits_() % n); }

  private:
    std::mt19937_64 bits_;
};

/// The number of points along each axis of a grid of n points; its reciprocal is their spacing.
template <int d>
[[nodiscard]] std::size_t grid_side(std::size_t n);

/// n points of a family.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> generate(Point_family family, std::size_t n, std::uint64_t seed);

/// A point of the family `clusters` is at centre + offset.
template <int d>
struct Point_of_cluster {
    Coordinates<d> centre, offset;
};
template <int d>
[[nodiscard]] std::vector<Point_of_cluster<d>> points_of_clusters(std::size_t n, std::uint64_t seed);

extern template std::size_t grid_side<2>(std::size_t);
extern template std::size_t grid_side<3>(std::size_t);
extern template std::vector<Point_of_cluster<2>> points_of_clusters<2>(std::size_t, std::uint64_t);
extern template std::vector<Point_of_cluster<3>> points_of_clusters<3>(std::size_t, std::uint64_t);
extern template std::vector<Coordinates<2>> generate<2>(Point_family, std::size_t, std::uint64_t);
extern template std::vector<Coordinates<3>> generate<3>(Point_family, std::size_t, std::uint64_t);

}  // namespace annulus::inline v1
