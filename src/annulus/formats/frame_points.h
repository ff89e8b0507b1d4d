// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/recorded_motion.h>

#include <cstdint>
#include <string>
#include <vector>

namespace annulus {

/// What to do with points that are at one place in one frame.
enum class Coincident {
    refuse,  ///< an Input_error(duplicate_point)
    merge,   ///< the one with the least id stands for all; the others are absent from this frame
};

/// Points of one frame that a triangulation can have: none outside the domain of the library, no two equal, no -0.
template <int d>
struct Frame_points {
    std::uint64_t number = 0;         ///< what the file calls the frame
    std::vector<std::uint64_t> id{};  ///< ascending
    std::vector<Coordinates<d>> x{};
    std::uint64_t merged = 0;  ///< points that another one stands for
};

/// In two dimensions without their z. Throws Input_error, with the name of the file. O(n log n).
template <int d>
[[nodiscard]] Frame_points<d> points_of(const std::string& name, const Frame& frame, Coincident coincident);

extern template Frame_points<2> points_of<2>(const std::string&, const Frame&, Coincident);
extern template Frame_points<3> points_of<3>(const std::string&, const Frame&, Coincident);

}  // namespace annulus
