// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/file_box.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The positions of the points of one time step, if there are any. Ids differ; coordinates are finite.
struct Frame {
    std::uint64_t number = 0;       ///< the number in the file, or the position in it, from 0
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
