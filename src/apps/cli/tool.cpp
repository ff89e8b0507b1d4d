// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/environment.h>
#include <annulus/error.h>
#include <annulus/version.h>
#include <apps/cli/arguments.h>
#include <apps/cli/interruption.h>
#include <apps/cli/process.h>
#include <apps/cli/tool.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <new>
#include <stdexcept>

namespace annulus::inline v1::cli {

namespace {

/// Prints a message as one line on standard error, and returns the status.
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
        case Error_code::duplicate_point:
        case Error_code::too_few:
        case Error_code::too_large:
        case Error_code::bad_input: return bad_input;
        case Error_code::wrong_size:
        case Error_code::unknown_vertex:
        case Error_code::environment: break;
    }
    return our_fault;
}

/// Runs a function that may throw. Every exception becomes one line on standard error and an exit status.
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
    } catch (const std::length_error&) {  // larger than any memory
        return complain("out of memory", our_fault);
    } catch (const std::exception& e) {
        return complain(e.what(), our_fault);
    }
}

int run(const std::vector<std::string>& words, std::span<const Subcommand> subcommands) {
    Invocation invocation;
    invocation.words = words;
    std::vector<std::string> outer = words;
    const auto dashes = std::find(outer.begin(), outer.end(), "--");
    if (dashes != outer.end() && outer.front() == "compare") {
        invocation.inner.assign(dashes + 1, outer.end());
        outer.erase(dashes, outer.end());
    }

    CLI::App app("annulus: a Delaunay triangulation kept right while its vertices move, certified", "annulus");
    app.set_version_flag("--version", "annulus " ANNULUS_VERSION_STRING);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    std::map<std::string, Run> runs;
    for (const Subcommand& s : subcommands) runs[s.name] = s.add(app, invocation);
    for (CLI::App* const sub : app.get_subcommands({})) refuse_empty_values(*sub);
    std::reverse(outer.begin(), outer.end());
    try {
        app.parse(outer);
    } catch (const CLI::Success& e) {  // --help, --version
        return app.exit(e);
    }
    require_sound_environment();
    return runs.at(app.get_subcommands().front()->get_name())();
}

}  // namespace

int run_tool(int argc, char** argv, std::span<const Subcommand> subcommands) {
    prepare_process();
    const std::vector<std::string> words(argv + (argc > 0 ? 1 : 0), argv + argc);
    int status = guarded([&] { return run(words, subcommands); });
    if (status == done || status == audit_failed) status = guarded([&] { return finish_output(), status; });
    Interruption_guard::end_if_interrupted();
    return status;
}

}  // namespace annulus::inline v1::cli
