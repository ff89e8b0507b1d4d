// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/io/input_error.h>
#include <annulus/motion/recorded_motion.h>

#include <filesystem>

namespace annulus {

/// Reads a recorded motion.
///
/// `.xyz`: frames one after the other, each a count, a comment line and that many points, `[element] x y [z] ...`; where
/// the comment has `Properties=` (extended XYZ) it says which column `pos` is. A point's id is its place in the frame.
/// `.csv`: a header that names the columns frame, id, x, y and perhaps z; frames are integers that do not decrease, ids
/// integers that differ within a frame.
///
/// Throws Input_error for everything that is wrong with the file, which includes having no frame, and a frame without
/// points. Linear but for sorting the ids of a frame.
[[nodiscard]] Recorded_motion read_motion(const std::filesystem::path& file);

}  // namespace annulus
