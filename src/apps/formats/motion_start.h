// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/motion_reader.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The frames of a motion up to the first one with points, and the dimension of all of it.
struct Motion_start {
    std::vector<std::uint64_t> empty{};  ///< numbers of the frames without points that come first
    Frame first{};
    int dimension = 2;
    std::string why{};  ///< why points with a z are a 2D motion: "z is the same everywhere: 0.5"
};

/// Reads these frames; the reader is that of the file with these options, at its beginning. A dimension of 0 is to be
/// found: 3 if z is not the same everywhere, for which a regular file is read a second time; of what cannot be read
/// twice, if z differs in the first frame with points. Throws Input_error.
[[nodiscard]] Motion_start start_motion(Motion_reader& reader, const std::filesystem::path& file,
                                        const Motion_options& options, int dimension);

}  // namespace annulus::inline v1
