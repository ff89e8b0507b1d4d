// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <apps/motion/generated_points.h>

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// Points that fill a periodic box without a defect.
enum class Crystal { square, triangular, sc, bcc, fcc, diamond };
/// Their names, as in the tool: two in 2D, four in 3D.
inline constexpr std::array<std::pair<std::string_view, Crystal>, 6> crystals{{{"square", Crystal::square},
                                                                               {"triangular", Crystal::triangular},
                                                                               {"sc", Crystal::sc},
                                                                               {"bcc", Crystal::bcc},
                                                                               {"fcc", Crystal::fcc},
                                                                               {"diamond", Crystal::diamond}}};
[[nodiscard]] constexpr int dimension_of(Crystal c) { return c <= Crystal::triangular ? 2 : 3; }
/// The number of points in a unit cell; that of `triangular` is a rectangle of edges 1 and sqrt(3).
[[nodiscard]] std::size_t points_of_unit_cell(Crystal c);

/// How many unit cells lie along each vector of the box, with edges as equal as can be (of `triangular`, with their
/// ratio): edges are those of n points, rounded. None where so many cells have not n points. Precondition: d is the
/// dimension of the crystal. O(1).
template <int d>
[[nodiscard]] std::optional<std::array<std::size_t, static_cast<std::size_t>(d)>> unit_cells(const Box<d>& box,
                                                                                             Crystal c, std::size_t n);
/// The numbers next to n, below and above, of points for which there are unit_cells, those that exist up to 10^8.
template <int d>
[[nodiscard]] std::vector<std::size_t> numbers_that_fit(const Box<d>& box, Crystal c, std::size_t n);

/// The crystal, unit cell after unit cell. Points are at shares of the vectors that are fractions of small integers,
/// so exactly where these and the vectors are binary fractions. Its cells are sheared and stretched as the box is.
template <int d>
[[nodiscard]] std::vector<Coordinates<d>> crystal_in(const Box<d>& box, Crystal c,
                                                     const std::array<std::size_t, static_cast<std::size_t>(d)>& cells);

/// Moves each coordinate by a random number of this standard deviation, at most 3.5 times it.
template <int d>
void vibrate(std::span<Coordinates<d>> points, double deviation, std::uint64_t seed);

extern template std::optional<std::array<std::size_t, 2>> unit_cells<2>(const Box<2>&, Crystal, std::size_t);
extern template std::optional<std::array<std::size_t, 3>> unit_cells<3>(const Box<3>&, Crystal, std::size_t);
extern template std::vector<std::size_t> numbers_that_fit<2>(const Box<2>&, Crystal, std::size_t);
extern template std::vector<std::size_t> numbers_that_fit<3>(const Box<3>&, Crystal, std::size_t);
extern template std::vector<Coordinates<2>> crystal_in<2>(const Box<2>&, Crystal, const std::array<std::size_t, 2>&);
extern template std::vector<Coordinates<3>> crystal_in<3>(const Box<3>&, Crystal, const std::array<std::size_t, 3>&);
extern template void vibrate<2>(std::span<Coordinates<2>>, double, std::uint64_t);
extern template void vibrate<3>(std::span<Coordinates<3>>, double, std::uint64_t);

}  // namespace annulus::inline v1
