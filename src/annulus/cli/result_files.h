// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/arguments.h>
#include <annulus/cli/interruption.h>
#include <annulus/formats/output_directory.h>

#include <string_view>

namespace annulus::cli {

/// Names of the files that any subcommand writes.
[[nodiscard]] bool is_result(std::string_view name);

/// What a subcommand writes to --output, all of it or nothing: a signal that comes meanwhile waits until all is in
/// place. A directory with files in it is refused, unless annulus has written results there, or with --force.
class Result_files {
  public:
    /// `replaced` are the earlier results that these make obsolete. An interrupted run writes to DIR.partial.
    explicit Result_files(const Common_arguments& arguments, Output_directory::Replaced replaced = is_result,
                          bool interrupted = false);
    void write(std::string_view name, std::string_view content) { out_.write(name, content); }
    /// Where one is written bit by bit, before the commit.
    [[nodiscard]] std::filesystem::path path_of(std::string_view name) { return out_.path_of(name); }
    /// Those of another, which then has none.
    void take(Result_files& other) { out_.take(other.out_); }
    void commit() { out_.commit(); }

  private:
    Interruption_guard guard_;  // first, so that it goes last
    Output_directory out_;
};

/// Throws when --output cannot be written to: better known before a long run than after it. Leaves nothing behind.
void require_writable(const Common_arguments& arguments, Output_directory::Replaced replaced = is_result);

/// The name of the directory that an interrupted run writes to: DIR.partial.
[[nodiscard]] std::string partial(const std::string& directory);

}  // namespace annulus::cli
