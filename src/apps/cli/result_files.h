// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/arguments.h>
#include <apps/cli/interruption.h>
#include <apps/formats/output_directory.h>

#include <string_view>

namespace annulus::inline v1::cli {

/// Whether some subcommand writes files with this name.
[[nodiscard]] bool is_result(std::string_view name);

/// The files that a subcommand writes to --output, all of them or none: a signal that arrives meanwhile takes effect
/// after all files are in place. A directory that is not empty is refused, unless annulus has written results there, or
/// with --force.
class Result_files {
  public:
    /// `replaced` are the earlier results that these make obsolete. An interrupted run writes to DIR.partial.
    explicit Result_files(const Common_arguments& arguments, Output_directory::Replaced replaced = is_result,
                          bool interrupted = false);
    void write(std::string_view name, std::string_view content) { out_.write(name, content); }
    /// The path for a file that is written piece by piece before the commit.
    [[nodiscard]] std::filesystem::path path_of(std::string_view name) { return out_.path_of(name); }
    /// Takes the files of another object, which then has none.
    void take(Result_files& other) { out_.take(other.out_); }
    void commit() { out_.commit(); }

  private:
    Interruption_guard guard_;  // declared first, so that it is destroyed last
    Output_directory out_;
};

/// Throws if --output cannot be written to, so that this is known before a long run. Leaves nothing behind.
void require_writable(const Common_arguments& arguments, Output_directory::Replaced replaced = is_result);

/// The name of the directory that an interrupted run writes to: DIR.partial.
[[nodiscard]] std::string partial(const std::string& directory);

}  // namespace annulus::inline v1::cli
