// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/companion.h>
#include <apps/cli/compare.h>

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace annulus::inline v1::cli {

namespace {

namespace fs = std::filesystem;

/// The path of the companion program, also if this program was started through links.
fs::path find_companion(const std::string& program) {
    const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
    for (const fs::path& directory : {here, here.parent_path() / ANNULUS_LIBEXEC}) {
        std::error_code ignored;
        if (fs::is_regular_file(directory / program, ignored)) return directory / program;
    }
    throw std::runtime_error(program + " is missing: it is a program of its own, expected beside annulus in " +
                             here.string());
}

/// Replaces the process by `program`; throws if that fails.
[[noreturn]] void become(const std::string& program, const Invocation& invocation) {
    const std::string path = find_companion(program).string();
    std::vector<char*> argv{const_cast<char*>(path.c_str())};
    for (const std::string& word : invocation.words) argv.push_back(const_cast<char*>(word.c_str()));
    argv.push_back(nullptr);
    ::execv(path.c_str(), argv.data());
    throw std::system_error(errno, std::generic_category(), path);
}

/// Whether the command line begins with this subcommand: then the companion parses its arguments, including --help.
bool is_first(const Invocation& invocation, std::string_view name) {
    return !invocation.words.empty() && invocation.words.front() == name;
}

Run add_companion(CLI::App& app, const Invocation& invocation, const std::string& name, const char* summary) {
    if (is_first(invocation, name)) become("annulus-" + name, invocation);
    app.add_subcommand(name, summary);
    return [name, &invocation]() -> int { become("annulus-" + name, invocation); };
}

}  // namespace

Run add_nodt_companion(CLI::App& app, const Invocation& invocation) {
    return add_companion(app, invocation, "nodt", nodt_summary);
}
Run add_sweep_companion(CLI::App& app, const Invocation& invocation) {
    return add_companion(app, invocation, "sweep", sweep_summary);
}
Run add_reproduce_companion(CLI::App& app, const Invocation& invocation) {
    return add_companion(app, invocation, "reproduce", reproduce_summary);
}

Run add_compare_command(CLI::App& app, const Invocation& invocation) {
    if (is_first(invocation, "compare") && !invocation.inner.empty() && invocation.inner.front() == "nodt")
        become("annulus-nodt", invocation);
    return add_compare(app, invocation, nullptr);
}

}  // namespace annulus::inline v1::cli
