// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_mesh.h>
#include <apps/cli/boxed_mesh.h>

#include <array>
#include <vector>

namespace annulus::inline v1::cli {

/// A triangulation as a mesh of finite cells, for files and pictures: without free indices, and of a periodic one the
/// points near the box, followed by the images of them that its cells have as corners.
template <int d>
struct Solid_mesh {
    using Cell = std::array<Index, static_cast<std::size_t>(d) + 1>;
    std::vector<Coordinates<d>> points;
    std::vector<Index> vertex;  ///< of the triangulation, by point
    std::vector<Cell> cells;    ///< of points
};

/// The outline of a box from the origin, for pictures.
[[nodiscard]] inline std::vector<Coordinates<2>> outline_of(const Box<2>& box) {
    const auto& [a, b] = box.vectors();
    return {{0, 0}, a, {a[0] + b[0], a[1] + b[1]}, b};
}

/// After the caption of a picture of a periodic one.
inline constexpr const char* with_images = ", with images at the sides of the box";

template <int d>
[[nodiscard]] Solid_mesh<d> solid_mesh(const Moving_mesh<d>& dt);
template <int d>
[[nodiscard]] Solid_mesh<d> solid_mesh(const Boxed_mesh<d>& dt);

/// For pictures: of each cell the image whose middle is in the box of the vectors from the origin, and only points that
/// are corners of them. O(n log n).
template <int d>
[[nodiscard]] Solid_mesh<d> cells_in_box(const Boxed_mesh<d>& dt);

extern template Solid_mesh<2> solid_mesh(const Moving_mesh<2>&);
extern template Solid_mesh<3> solid_mesh(const Moving_mesh<3>&);
extern template Solid_mesh<2> solid_mesh(const Boxed_mesh<2>&);
extern template Solid_mesh<3> solid_mesh(const Boxed_mesh<3>&);
extern template Solid_mesh<2> cells_in_box(const Boxed_mesh<2>&);
extern template Solid_mesh<3> cells_in_box(const Boxed_mesh<3>&);

}  // namespace annulus::inline v1::cli
