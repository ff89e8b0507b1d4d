// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/commands.h>
#include <annulus/cli/guided_motion.h>
#include <annulus/cli/nodt_scene.h>

#include <memory>

namespace annulus::cli {

/// Makes the motion of natural ODT; throws as `make_scene`.
using Make_nodt = std::unique_ptr<Guided_motion<Moving_mesh_3>> (*)(const Nodt_arguments& arguments,
                                                                    const Common_arguments& common);

/// `compare`, in the program that has natural ODT and in the one that leaves that to it: there `make_nodt` is null and
/// `-- nodt` does not come here.
Run add_compare(CLI::App& app, const Invocation& invocation, Make_nodt make_nodt);

}  // namespace annulus::cli
