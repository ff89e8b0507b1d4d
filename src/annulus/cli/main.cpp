// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/environment.h>
#include <annulus/arithmetic/error.h>
#include <annulus/cli/arguments.h>
#include <annulus/cli/commands.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>

namespace annulus::cli {

namespace {

/// One line, whatever the message.
int complain(std::string message, int status) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::fprintf(stderr, "annulus: %s\n", message.c_str());
    return status;
}

int run(int argc, char** argv) {
    Invocation invocation;
    for (int i = 1; i < argc; ++i) invocation.words.emplace_back(argv[i]);
    std::vector<std::string> outer = invocation.words;
    const auto dashes = std::find(outer.begin(), outer.end(), "--");
    if (dashes != outer.end() && outer.front() == "compare") {
        invocation.inner.assign(dashes + 1, outer.end());
        outer.erase(dashes, outer.end());
    }

    CLI::App app("annulus: a Delaunay triangulation kept right while its vertices move, certified", "annulus");
    app.set_version_flag("--version", "annulus " ANNULUS_VERSION);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    std::map<std::string, Run> commands;
    commands["lloyd"] = add_lloyd_command(app, invocation);
    commands["nodt"] = add_nodt_command(app, invocation);
    commands["replay"] = add_replay_command(app, invocation);
    commands["compare"] = add_compare_command(app, invocation);
    commands["audit"] = add_audit_command(app, invocation);
    commands["degeneracy"] = add_degeneracy_command(app, invocation);
    commands["counterexample"] = add_counterexample_command(app, invocation);
    try {
        std::reverse(outer.begin(), outer.end());
        app.parse(outer);
        require_sound_environment();
        return commands.at(app.get_subcommands().front()->get_name())();
    } catch (const CLI::Success& e) {  // --help, --version
        return app.exit(e);
    } catch (const CLI::ParseError& e) {
        return complain(std::string(e.what()) + " (see annulus --help)", wrong_usage);
    } catch (const Error& e) {
        return complain(e.what(), e.code() == Error_code::usage ? wrong_usage : bad_input);
    } catch (const std::bad_alloc&) {
        return complain("out of memory", bad_input);
    } catch (const std::exception& e) {
        return complain(e.what(), bad_input);
    }
}

}  // namespace

}  // namespace annulus::cli

int main(int argc, char** argv) { return annulus::cli::run(argc, argv); }
