// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/motion_reader.h>

#include <filesystem>

namespace annulus::inline v1 {

/// All frames of a recorded motion at once, as Motion_reader gives them.
[[nodiscard]] Recorded_motion read_motion(const std::filesystem::path& file, const Motion_options& options = {});

}  // namespace annulus::inline v1
