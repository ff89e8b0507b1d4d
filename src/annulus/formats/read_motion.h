// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/formats/input_error.h>
#include <annulus/motion/recorded_motion.h>

#include <filesystem>

namespace annulus {

/// What to do where numbers of frames are further apart than others of the file: a frame without points has no row in CSV.
enum class Absent_frames {
    refuse,  ///< an Input_error
    empty,   ///< one frame without points stands for those that are absent: all points disappear and appear again
    skip,    ///< one step leads over them
};

/// Reads a recorded motion, by the extension of the file (either case, .gz after it).
///
/// `.xyz`: frames one after the other, see Xyz_frames. A point's id is its `id` in Properties, in all frames or none; else
/// its place in the frame, from 0. `.csv`: see Csv_frames; frames are numbered evenly, or `absent` says what to do.
/// Points appear and disappear by their id; frames may have no points.
///
/// Throws Input_error for everything that is wrong with the file, which includes having no point at all, and two of one id
/// in a frame. Linear but for sorting the ids of a frame.
[[nodiscard]] Recorded_motion read_motion(const std::filesystem::path& file,
                                          Absent_frames absent = Absent_frames::refuse);

}  // namespace annulus
