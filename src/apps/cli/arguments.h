// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/options.h>
#include <apps/formats/format.h>
#include <apps/formats/number_list.h>

#include <CLI/CLI.hpp>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1::cli {

/// Exit status of the tool. `our_fault` is also that of failures of the machine: memory, disk.
enum Exit : int { done = 0, audit_failed = 1, wrong_usage = 2, bad_input = 3, our_fault = 4 };

/// The arguments that every subcommand accepts.
struct Common_arguments {
    std::string output;
    bool force = false;
    std::uint64_t seed = 1;
    int threads = 1;
    bool quiet = false;

    /// Prints on standard error that `count` duplicate points of the file were merged, if there were any.
    void say_merged(const std::string& file, std::uint64_t count) const;
    /// Prints notes on standard error, one per line: what the file contains that is ignored.
    void say_notes(const std::vector<std::string>& notes) const;
};

/// The arguments that every subcommand that runs a motion accepts.
struct Tracking_arguments {
    std::string strategy = "auto";
    std::string tolerance = "certified";
    std::uint64_t audit = 100;
};

/// Plain decimal digits, from least to most. CLI11 itself would read 010 as 8, and a number that is too large as the
/// largest one.
[[nodiscard]] CLI::Validator whole_number(std::uint64_t least, std::uint64_t most);
/// A number from least to most. CLI::Range itself would accept NaN.
[[nodiscard]] CLI::Validator number_within(double least, double most);

/// `files` are the files that --output writes. If nothing is random or parallel, --seed and --threads are accepted and
/// have no effect, so that a script may pass the same options to every subcommand. Common_words are the descriptions of
/// these two options in --help.
struct Common_words {
    std::string seed = "Seed of everything random";
    std::string threads = "Threads for motion and triangulation; results do not depend on them";
};
inline const std::string no_seed = "Accepted by all subcommands; nothing is random here";
inline const std::string no_threads = "Accepted by all subcommands; one thread is used here";
void add_common(CLI::App& app, Common_arguments& arguments, const std::string& files, const Common_words& words = {});
/// --format: the format of a file, whatever its extension says.
void add_format(CLI::App& app, std::string& format, std::span<const Format> formats);
/// --columns: the columns of a table.
void add_columns(CLI::App& app, std::string& columns);
/// Of a command that takes periodic boxes --strategy may be `signs`, too.
void add_tracking(CLI::App& app, Tracking_arguments& arguments, bool boxed = false);

/// Every option of a subcommand refuses the value "", which would otherwise be the same as no option, and so does every
/// name of a file. Precondition: all of them have been added.
void refuse_empty_values(CLI::App& app);

/// Options of the library from those of the command line. Throws Error(usage).
[[nodiscard]] Options options_of(const Tracking_arguments& tracking, const Common_arguments& common);
/// The same in a periodic box, where `auto`, `rebuild`, `signs` and `tolerances` are strategies: whole time steps, also
/// for Strategy::in_place, which stands for `signs`. The error ends with `otherwise`.
[[nodiscard]] Options boxed_options_of(const Tracking_arguments& tracking, const Common_arguments& common,
                                       const std::string& otherwise = {});

/// The command line, quoted where a shell needs it, for the files of the run.
[[nodiscard]] std::string command_line(const std::vector<std::string>& words);

}  // namespace annulus::inline v1::cli
