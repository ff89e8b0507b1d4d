// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/arguments.h>
#include <apps/reproduction/plan.h>

#include <memory>
#include <string>

namespace annulus::inline v1::cli {

/// The motions of a reproduction: Lloyd iterations and natural ODT as in the tool, and points of which only some move.
/// `surfaces` is the directory with the bodies.
[[nodiscard]] std::unique_ptr<Scene<2>> plane_scene(const Motion_plan& motion, const Common_arguments& common);
[[nodiscard]] std::unique_ptr<Scene<3>> space_scene(const Motion_plan& motion, const std::string& surfaces,
                                                    const Common_arguments& common);

}  // namespace annulus::inline v1::cli
