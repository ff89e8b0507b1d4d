// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/tracker.h>
#include <annulus/motion/cells_3.h>

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

/// The same of a run in space, where `domain` is the mesh that was optimised: its cells are those with a flag among all
/// finite cells. final.mesh and final.vtu hold the triangulation, domain.mesh the domain's cells alone; dihedral.csv has
/// the dihedral angles.
void write_run(const std::string& directory, const Tracker_3& tracker, const Cells_3& cells,
               std::span<const char> domain, std::optional<Picture> before, std::optional<Picture> after,
               std::vector<std::string> notes);

/// The few lines a run prints at its end.
template <class Moving>
void print_summary(const Tracker<Moving>& tracker);

extern template void print_summary(const Tracker_2&);
extern template void print_summary(const Tracker_3&);

}  // namespace annulus::cli
