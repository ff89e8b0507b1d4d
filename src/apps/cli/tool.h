// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/commands.h>

#include <span>

namespace annulus::inline v1::cli {

/// A subcommand of a program: its name and the function that registers it.
struct Subcommand {
    const char* name;
    Run (*add)(CLI::App& app, const Invocation& invocation);
};

/// The main function of `annulus` and of the programs that it starts: parses the command line, runs its subcommand, and
/// returns the exit status. Every exception becomes one line on standard error.
int run_tool(int argc, char** argv, std::span<const Subcommand> subcommands);

}  // namespace annulus::inline v1::cli
