// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/arguments.h>
#include <annulus/cli/mesh_3.h>
#include <annulus/cli/tracker.h>

#include <optional>
#include <string>

namespace annulus::cli {

/// What `write_run` writes, in words.
inline constexpr const char* run_files = "summary.json, iterations.csv, final.mesh, final.vtu and report.html";

/// Writes summary.json, iterations.csv, final.mesh, final.vtu and report.html of one run, all or none: to --output, or
/// beside it when the run was interrupted. `step` is what a step is called in the heading. `stipples` is stipples.svg, where it is not empty.
void write_run(const Common_arguments& arguments, const Tracker_2& tracker, const std::string& step,
               std::optional<Picture> before, std::vector<std::string> notes, const std::string& stipples = {});

/// "500 vertices, 50 Lloyd iterations: NAMES", for the head of a report; `step` is "Lloyd iteration".
[[nodiscard]] std::string title_of(const Run_record& run, const std::string& step, const std::string& names);

/// The same of a run in space that ended with `mesh`. With `domain` a part of the triangulation is the mesh of a domain
/// that was optimised: then domain.mesh has its cells alone and dihedral.csv the dihedral angles.
void write_run(const Common_arguments& arguments, const Tracker_3& tracker, const std::string& step, const Mesh_3& mesh,
               bool domain, std::optional<Picture> before, std::optional<Picture> after,
               std::vector<std::string> notes);

/// One line on standard error: how far an interrupted run came, of `steps`, and where that is.
void say_interrupted(const Common_arguments& arguments, std::uint64_t done_steps, std::uint64_t steps);

/// The few lines a run prints at its end.
template <class Moving>
void print_summary(const Tracker<Moving>& tracker);

extern template void print_summary(const Tracker_2&);
extern template void print_summary(const Tracker_3&);

}  // namespace annulus::cli
