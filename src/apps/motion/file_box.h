// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <array>
#include <cstdint>
#include <string>

namespace annulus::inline v1 {

/// A box as a file gives it for one frame. Where it has its corner does not matter.
struct File_box {
    std::array<Coordinates<3>, 3> vectors{};
    std::array<bool, 3> periodic{};  ///< by vector
    std::string what{};              ///< what declares it: "Lattice and pbc", "BOX BOUNDS pp pp pp"
    std::uint64_t line = 0;          ///< where, from 1
};

}  // namespace annulus::inline v1
