// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/tracker_2.h>

#include <optional>
#include <string>

namespace annulus::cli {

/// Writes summary.json, iterations.csv, final.mesh, final.vtu and report.html of one run, all or none.
void write_run(const std::string& directory, const Tracker_2& tracker, std::optional<Picture> before,
               std::vector<std::string> notes);

/// The few lines a run prints at its end.
void print_summary(const Tracker_2& tracker);

}  // namespace annulus::cli
