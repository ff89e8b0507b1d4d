// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/interruption.h>
#include <annulus/io/output_directory.h>

#include <string>
#include <string_view>

namespace annulus::cli {

/// What a subcommand writes, all of it or nothing, also when it is interrupted meanwhile: a signal before `commit` takes
/// everything back, one during it waits until all files are in place; then the process ends by it.
class Result_files {
  public:
    explicit Result_files(const std::string& directory) : out_(directory) {}
    void write(std::string_view name, std::string_view content);
    void commit();

  private:
    void stop_if_interrupted() const;

    Interruption_guard guard_;  // first, so that it goes last
    Output_directory out_;
};

/// Throws Error(bad_input) when `directory` cannot be written to: better known before a long run than after it. Leaves
/// nothing behind.
void require_writable(const std::string& directory);

}  // namespace annulus::cli
