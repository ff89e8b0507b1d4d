// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/companion.h>

#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <stdexcept>
#include <system_error>

namespace annulus::cli {

namespace {

namespace fs = std::filesystem;

/// The path of the program, whatever links lead to it.
fs::path find_companion(const std::string& program) {
    const fs::path here = fs::read_symlink("/proc/self/exe").parent_path();
    for (const fs::path& directory : {here, here.parent_path() / ANNULUS_LIBEXEC}) {
        std::error_code ignored;
        if (fs::is_regular_file(directory / program, ignored)) return directory / program;
    }
    throw std::runtime_error(program + " is missing: it is a program of its own, expected beside annulus in " + here.string());
}

Run add_companion(CLI::App& app, const Invocation& invocation, const std::string& name, const char* summary) {
    const auto become = [name, words = invocation.words]() -> int {
        const std::string path = find_companion("annulus-" + name).string();
        std::vector<char*> argv{const_cast<char*>(path.c_str())};
        for (const std::string& word : words) argv.push_back(const_cast<char*>(word.c_str()));
        argv.push_back(nullptr);
        ::execv(path.c_str(), argv.data());
        throw std::system_error(errno, std::generic_category(), path);
    };
    app.add_subcommand(name, summary);
    // Its arguments, --help included, are read there.
    if (!invocation.words.empty() && invocation.words.front() == name) become();
    return become;
}

}  // namespace

Run add_sweep_companion(CLI::App& app, const Invocation& invocation) { return add_companion(app, invocation, "sweep", sweep_summary); }
Run add_reproduce_companion(CLI::App& app, const Invocation& invocation) {
    return add_companion(app, invocation, "reproduce", reproduce_summary);
}

}  // namespace annulus::cli
