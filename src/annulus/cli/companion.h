// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/commands.h>

namespace annulus::cli {

/// What --help says of the subcommands that are programs of their own.
inline constexpr const char* nodt_summary = "Natural-ODT optimisation of a tetrahedral mesh of a closed surface";
inline constexpr const char* sweep_summary =
    "Degeneracy of many generated or recorded inputs, as a file specifies; on several machines under MPI";
inline constexpr const char* reproduce_summary =
    "Figures and claims of the paper on vertex tolerances, from runs made here, as pages";

/// `annulus nodt`, `annulus sweep` and `annulus reproduce`: the process becomes the program annulus-nodt, annulus-sweep
/// or annulus-reproduce, with the same arguments. It lies beside this program, or in ../libexec/annulus where both are
/// installed; throws std::runtime_error where it is in neither.
Run add_nodt_companion(CLI::App& app, const Invocation& invocation);
Run add_sweep_companion(CLI::App& app, const Invocation& invocation);
Run add_reproduce_companion(CLI::App& app, const Invocation& invocation);
/// `annulus compare`: annulus-nodt where it is on natural ODT, else done here.
Run add_compare_command(CLI::App& app, const Invocation& invocation);

}  // namespace annulus::cli
