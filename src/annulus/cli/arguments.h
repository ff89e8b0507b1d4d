// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/options.h>
#include <annulus/formats/format.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace annulus::cli {

/// Exit status of the tool. `our_fault` is the machine's too: memory, disk.
enum Exit : int { done = 0, audit_failed = 1, wrong_usage = 2, bad_input = 3, our_fault = 4 };

/// What every subcommand takes.
struct Common_arguments {
    std::string output;
    bool force = false;
    std::uint64_t seed = 1;
    int threads = 1;
    bool quiet = false;

    /// Says on standard error that `count` duplicate points of the file were merged, if there were any.
    void say_merged(const std::string& file, std::uint64_t count) const;
    /// Says on standard error what a file says and is ignored, a line for each note.
    void say_notes(const std::vector<std::string>& notes) const;
};

/// What every subcommand that runs a motion takes.
struct Tracking_arguments {
    std::string strategy = "auto";
    std::string tolerance = "certified";
    std::uint64_t audit = 100;
};

/// Plain decimal digits, from least to most: CLI11 by itself takes 010 for 8, and what is too large for the largest
/// there is.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);
/// From least to most: CLI::Range by itself takes NaN.
[[nodiscard]] CLI::Validator number_within(double least, double most);

/// `files` is what --output writes. Where nothing is random or parallel, --seed and --threads are taken and have no
/// effect, so that a script may give every subcommand the same options; --help says so: these are its words about
/// them.
struct Common_words {
    std::string seed = "Seed of everything random";
    std::string threads = "Threads for motion and triangulation; results do not depend on them";
};
inline const std::string no_seed = "Taken everywhere; nothing is random here";
inline const std::string no_threads = "Taken everywhere; one thread is used here";
void add_common(CLI::App& app, Common_arguments& arguments, const std::string& files, const Common_words& words = {});
/// --format: what a file is, whatever its extension says.
void add_format(CLI::App& app, std::string& format, std::span<const Format> formats);
void add_tracking(CLI::App& app, Tracking_arguments& arguments);

/// Library options from words. Throws Error(usage).
[[nodiscard]] Options options_of(const Tracking_arguments& tracking, const Common_arguments& common);

/// The words of the command line, quoted where a shell would need it, for the files of the run.
[[nodiscard]] std::string command_line(const std::vector<std::string>& words);

}  // namespace annulus::cli
