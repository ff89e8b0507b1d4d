// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/frame_files.h>
#include <apps/cli/lloyd_scene.h>

#include <string>

namespace annulus::inline v1::cli {

/// The arguments of `lloyd --box`.
struct Boxed_lloyd_call {
    const Common_arguments& common;
    const Tracking_arguments& tracking;
    const Lloyd_arguments& lloyd;
    const Frame_arguments& frames;
    const std::string& box;
};

/// Lloyd iterations in the periodic box of --box, in 2D or 3D, with density 1. Returns the exit status. Throws
/// Input_error or Error.
[[nodiscard]] int run_boxed_lloyd(const Boxed_lloyd_call& call, const std::string& command);

}  // namespace annulus::inline v1::cli
