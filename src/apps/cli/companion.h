// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/commands.h>

namespace annulus::inline v1::cli {

/// The descriptions in --help of the subcommands that are separate programs.
inline constexpr const char* nodt_summary = "Natural-ODT optimisation of a tetrahedral mesh of a closed surface";
inline constexpr const char* sweep_summary =
    "Degeneracy of many generated or recorded inputs, as a file specifies; on several machines under MPI";
inline constexpr const char* reproduce_summary =
    "Figures and claims of the paper on vertex tolerances, from runs made here, as pages";

/// `annulus nodt`, `annulus sweep` and `annulus reproduce`: the process is replaced by the program annulus-nodt,
/// annulus-sweep or annulus-reproduce, with the same arguments. That program is in the directory of this one, or in
/// ../libexec/annulus if they are installed; throws std::runtime_error if it is in neither.
Run add_nodt_companion(CLI::App& app, const Invocation& invocation);
Run add_sweep_companion(CLI::App& app, const Invocation& invocation);
Run add_reproduce_companion(CLI::App& app, const Invocation& invocation);
/// `annulus compare`: runs annulus-nodt if the motion is natural ODT; other motions are compared in this process.
Run add_compare_command(CLI::App& app, const Invocation& invocation);

}  // namespace annulus::inline v1::cli
