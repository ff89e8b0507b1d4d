// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace annulus::inline v1::cli {

/// A subcommand registers itself with the application and returns a function that runs it and returns the exit status.
using Run = std::function<int()>;

/// `words` is the command line without the program, `inner` the part after `--`.
struct Invocation {
    std::vector<std::string> words;
    std::vector<std::string> inner;
};

Run add_lloyd_command(CLI::App& app, const Invocation& invocation);
Run add_nodt_command(CLI::App& app, const Invocation& invocation);
Run add_advise_command(CLI::App& app, const Invocation& invocation);
Run add_replay_command(CLI::App& app, const Invocation& invocation);
Run add_audit_command(CLI::App& app, const Invocation& invocation);
Run add_degeneracy_command(CLI::App& app, const Invocation& invocation);
Run add_generate_command(CLI::App& app, const Invocation& invocation);
Run add_sweep_command(CLI::App& app, const Invocation& invocation);
Run add_reproduce_command(CLI::App& app, const Invocation& invocation);
Run add_counterexample_command(CLI::App& app, const Invocation& invocation);

}  // namespace annulus::inline v1::cli
