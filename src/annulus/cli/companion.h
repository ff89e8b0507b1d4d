// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/commands.h>

namespace annulus::cli {

/// What --help says of the two subcommands that are programs of their own.
inline constexpr const char* sweep_summary =
    "Degeneracy of many generated or recorded inputs, as a file specifies; on several machines under MPI";
inline constexpr const char* reproduce_summary =
    "Figures and claims of the paper on vertex tolerances, from runs made here, as pages";

/// `annulus sweep` and `annulus reproduce`: the process becomes the program annulus-sweep or annulus-reproduce, with the same arguments.
/// It lies beside this program, or in ../libexec/annulus where both are installed; throws std::runtime_error where it is in neither.
Run add_sweep_companion(CLI::App& app, const Invocation& invocation);
Run add_reproduce_companion(CLI::App& app, const Invocation& invocation);

}  // namespace annulus::cli
