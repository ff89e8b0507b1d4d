// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/file_box.h>

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The time of a frame that has none, NaN.
inline constexpr double no_time = std::numeric_limits<double>::quiet_NaN();

/// The positions of the points of one time step, if there are any. Ids differ; coordinates are finite.
struct Frame {
    std::uint64_t number = 0;       ///< the number in the file, or the position in it, from 0
    double time = no_time;          ///< in a table that has times in place of numbers of frames
    std::vector<std::uint64_t> id;  ///< ascending
    std::vector<Coordinates<3>> position;
    std::vector<std::uint64_t> line;  ///< of each point in the file, from 1
    std::optional<File_box> box{};    ///< where boxes are taken, and the file has one here
};

/// A motion from a file: points with an id that may appear and disappear.
struct Recorded_motion {
    std::string name;
    bool has_z = false;
    std::vector<std::string> notes;  ///< content of the file that is ignored; each a line with the file's name
    std::vector<Frame> frames;
};

}  // namespace annulus::inline v1
