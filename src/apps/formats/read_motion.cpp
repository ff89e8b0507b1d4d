// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/read_motion.h>

#include <utility>

namespace annulus::inline v1 {

Recorded_motion read_motion(const std::filesystem::path& file, const Motion_options& options) {
    Motion_reader reader(file, options);
    Recorded_motion motion;
    motion.name = reader.name();
    for (Frame frame; reader.next(frame);) motion.frames.push_back(std::exchange(frame, {}));
    motion.has_z = reader.has_z();
    motion.notes = reader.notes();
    return motion;
}

}  // namespace annulus::inline v1
