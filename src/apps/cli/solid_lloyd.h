// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/frame_files.h>
#include <apps/cli/lloyd_scene.h>

#include <string>

namespace annulus::inline v1::cli {

/// The arguments of `lloyd --domain box` in 3D.
struct Solid_lloyd_call {
    const Common_arguments& common;
    const Tracking_arguments& tracking;
    const Lloyd_arguments& lloyd;
    const Frame_arguments& frames;
};

/// Lloyd iterations in the 3D box of --size, which is not periodic, with density 1: targets are the centroids of the
/// Voronoi cells, clipped to the box. Returns the exit status. Throws Input_error or Error.
[[nodiscard]] int run_solid_lloyd(const Solid_lloyd_call& call, const std::string& command);

}  // namespace annulus::inline v1::cli
