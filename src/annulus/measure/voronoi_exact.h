// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstddef>
#include <span>

namespace annulus::inline v1 {

/// For the cell to the left of a facet: its corners except the opposite one, counter-clockwise seen from outside (in 2D
/// from p to q with the cell on the left).
template <int d>
inline constexpr std::array<std::array<std::size_t, static_cast<std::size_t>(d)>, static_cast<std::size_t>(d + 1)>
    facet_corners{};
template <>
inline constexpr std::array<std::array<std::size_t, 2>, 3> facet_corners<2>{{{1, 2}, {2, 0}, {0, 1}}};
template <>
inline constexpr std::array<std::array<std::size_t, 3>, 4> facet_corners<3>{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The area or volume of the Voronoi cell of vertex v, with a relative error below 2^-49 (in the normal range; the
/// largest double in place of what is larger). `around` are the cells with corner v, ascending, all of them, and no
/// facet at v is in the hull.
///
/// Circumcentres are exact quotients of integers, rounded to q binary places. Everything after that is exact, and q
/// grows until a bound of the rounding is small enough. About 4 us per cell for coordinates of one magnitude; more, as
/// multiplication of integers, where exponents are spread. Throws Error(bad_input) for a cell that is flat, and where a
/// neighbour is not among `around`.
template <int d>
[[nodiscard]] double exact_voronoi_volume(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells, Index v,
                                          std::span<const std::size_t> around);

extern template double exact_voronoi_volume<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&, Index,
                                               std::span<const std::size_t>);
extern template double exact_voronoi_volume<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&, Index,
                                               std::span<const std::size_t>);

}  // namespace annulus::inline v1
