// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/triangle_surface.h>

#include <array>
#include <cstdint>
#include <vector>

namespace annulus::inline v1 {

/// A box of voxels with labels; label 0 is outside. Voxel (i, j, k) has its centre at (i, j, k) times the spacing.
struct Labelled_image {
    std::array<std::size_t, 3> size{};
    Coordinates<3> spacing{1, 1, 1};  ///< edge lengths of a voxel, positive
    std::vector<std::uint8_t> label;  ///< x runs fastest, then y

    [[nodiscard]] std::uint8_t at(std::size_t i, std::size_t j, std::size_t k) const {
        return label[(k * size[1] + j) * size[0] + i];
    }
};

/// The surface between label 0 and all others, closed whatever the labels (what touches the border of the image is
/// closed there), counter-clockwise from outside.
///
/// Voxels are averaged in blocks (as equal in length as can be, so many that no side has more than `most` of them), and
/// the surface is where the trilinear samples cross one half, by marching tetrahedra, six to a cube. Averaging smooths
/// the staircase of voxels, and parts thinner than a block may vanish. Throws Error(bad_input) when nothing is left.
/// Linear.
[[nodiscard]] Triangle_surface surface_of(const Labelled_image& image, std::size_t most = 128);

}  // namespace annulus::inline v1
