// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/environment.h>
#include <annulus/arithmetic/error.h>
#include <annulus/cli/arguments.h>
#include <annulus/cli/commands.h>
#include <annulus/cli/interruption.h>
#include <annulus/cli/process.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <new>
#include <stdexcept>
#include <string>

namespace annulus::cli {

namespace {

/// One line, whatever the message.
int complain(std::string message, int status) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    std::fprintf(stderr, "annulus: %s\n", message.c_str());
    return status;
}

int status_of(Error_code code) {
    switch (code) {
        case Error_code::usage: return wrong_usage;
        case Error_code::not_finite:
        case Error_code::out_of_domain:
        case Error_code::collision:
        case Error_code::too_few:
        case Error_code::too_large:
        case Error_code::bad_input: return bad_input;
        case Error_code::wrong_size:
        case Error_code::unknown_vertex:
        case Error_code::environment: break;
    }
    return our_fault;
}

/// Runs what throws; every exception is one line on standard error and a status.
template <class Call>
int guarded(const Call& call) {
    try {
        return call();
    } catch (const CLI::ParseError& e) {
        return complain(std::string(e.what()) + " (see annulus --help)", wrong_usage);
    } catch (const Error& e) {
        return complain(e.what(), status_of(e.code()));
    } catch (const std::bad_alloc&) {
        return complain("out of memory", our_fault);
    } catch (const std::length_error&) {  // more than any memory has
        return complain("out of memory", our_fault);
    } catch (const std::exception& e) {
        return complain(e.what(), our_fault);
    }
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
    commands["generate"] = add_generate_command(app, invocation);
    commands["sweep"] = add_sweep_command(app, invocation);
    commands["reproduce"] = add_reproduce_command(app, invocation);
    commands["counterexample"] = add_counterexample_command(app, invocation);
    std::reverse(outer.begin(), outer.end());
    try {
        app.parse(outer);
    } catch (const CLI::Success& e) {  // --help, --version
        return app.exit(e);
    }
    require_sound_environment();
    return commands.at(app.get_subcommands().front()->get_name())();
}

}  // namespace

}  // namespace annulus::cli

int main(int argc, char** argv) {
    using namespace annulus::cli;
    prepare_process();
    int status = guarded([&] { return run(argc, argv); });
    if (status == done || status == audit_failed) status = guarded([&] { return finish_output(), status; });
    Interruption_guard::end_if_interrupted();
    return status;
}
