// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/commands.h>
#include <apps/cli/guided_motion.h>
#include <apps/cli/nodt_scene.h>

#include <memory>

namespace annulus::inline v1::cli {

/// Makes the motion of natural ODT; throws as `make_scene`.
using Make_nodt = std::unique_ptr<Guided_motion<Moving_mesh_3>> (*)(const Nodt_arguments& arguments,
                                                                    const Common_arguments& common);

/// `compare`, both in annulus-nodt, which has natural ODT, and in annulus, which runs annulus-nodt for `-- nodt`: there
/// `make_nodt` is null and not used.
Run add_compare(CLI::App& app, const Invocation& invocation, Make_nodt make_nodt);

}  // namespace annulus::inline v1::cli
