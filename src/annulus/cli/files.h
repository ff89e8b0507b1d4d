// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/tracker_2.h>

#include <optional>
#include <string>

namespace annulus::cli {

/// What `write_run` writes, in words.
inline constexpr const char* run_files = "summary.json, iterations.csv, final.mesh, final.vtu and report.html";

/// Writes summary.json, iterations.csv, final.mesh, final.vtu and report.html of one run, all or none.
void write_run(const std::string& directory, const Tracker_2& tracker, std::optional<Picture> before,
               std::vector<std::string> notes);

/// "500 vertices, 50 Lloyd iterations: NAMES", for the head of a report.
[[nodiscard]] std::string title_of(const Run_record& run, const std::string& names);

/// The few lines a run prints at its end.
void print_summary(const Tracker_2& tracker);

}  // namespace annulus::cli
