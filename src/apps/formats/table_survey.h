// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/file_bytes.h>
#include <apps/formats/table_columns.h>

#include <cstdint>
#include <optional>

namespace annulus::inline v1 {

/// What has to be known of the rows of a motion before they are read.
struct Table_survey {
    std::uint64_t rows = 0;
    bool in_order = true;         ///< frames do not decrease
    bool numbers_frames = true;   ///< frames are whole numbers of 0 or more; else they are times
    bool has_integer_ids = true;  ///< all ids are integers; else they are words
    /// The least difference of successive numbers of frames where these are in order; none for fewer than two frames.
    std::optional<std::uint64_t> least_distance{};
};

/// Reads a table once, up to its first fault, which is not reported: whatever reads the rows again will meet it. In
/// constant memory, linear time.
[[nodiscard]] Table_survey survey_table(File_bytes& bytes, const Column_choice& choice);

}  // namespace annulus::inline v1
