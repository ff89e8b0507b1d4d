// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/arguments.h>

#include <cstdint>
#include <string>

namespace annulus::inline v1::cli {

/// Which data of the frames of a run are written.
struct Frame_arguments {
    std::uint64_t every = 0;  ///< 0: no frames
    bool voronoi = false;
    bool changes = false;
    bool neighbors = false;
    std::string clip{};  ///< of replay alone: see parse_clip; empty without one

    [[nodiscard]] bool any() const { return every > 0 || voronoi || changes || neighbors; }
};

void add_frames(CLI::App& app, Frame_arguments& arguments);
/// Of replay: --clip.
void add_clip(CLI::App& app, Frame_arguments& arguments);
/// Throws Error(usage) for arguments that exclude each other. Sets report_changes in `options` if it is needed.
void prepare(const Frame_arguments& frames, const Common_arguments& common, Options& options);

}  // namespace annulus::inline v1::cli
