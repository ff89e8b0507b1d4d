// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/arguments.h>
#include <annulus/cli/frame_files.h>
#include <annulus/cli/tracker.h>
#include <annulus/formats/write_vtu.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace annulus::cli {

/// What `write_run` writes, in words.
inline constexpr const char* run_files = "summary.json, iterations.csv, final.mesh, final.vtu and report.html";

/// What a run has for its files and its page besides what its tracker knows.
template <class Moving>
struct Run_page {
    using Cell = std::array<Index, static_cast<std::size_t>(Moving::dimension_of_space) + 1>;

    std::string step;  ///< what a step is called in the heading: "Lloyd iteration"
    std::optional<Picture> before{}, after{};
    Film film{};  ///< in their place
    std::vector<Figure> figures{};
    std::vector<std::string> notes{};
    std::vector<Cell> cells{};                             ///< the solid ones, where they have an order of their own
    std::vector<Vtu_field> point_fields{}, cell_fields{};  ///< of final.vtu, further ones
    std::vector<std::pair<std::string, std::string>> files{};  ///< further ones, and what is in them
    Frame_files<Moving>* frames = nullptr;
};

/// Writes summary.json, iterations.csv, final.mesh, final.vtu and report.html of one run, and what its page has, all
/// or none: to --output, or beside it when the run was interrupted.
template <class Moving>
void write_run(const Common_arguments& arguments, const Tracker<Moving>& tracker, Run_page<Moving> page);

/// "500 vertices, 50 Lloyd iterations: NAMES", for the head of a report; `step` is "Lloyd iteration".
[[nodiscard]] std::string title_of(const Run_record& run, const std::string& step, const std::string& names);

/// One line on standard error: how far an interrupted run came, of `steps` where that is known, and where that is.
void say_interrupted(const Common_arguments& arguments, std::uint64_t done_steps,
                     std::optional<std::uint64_t> steps = std::nullopt);

/// The few lines a run prints at its end.
template <class Moving>
void print_summary(const Tracker<Moving>& tracker);

extern template void write_run(const Common_arguments&, const Tracker_2&, Run_page<Moving_mesh_2>);
extern template void write_run(const Common_arguments&, const Tracker_3&, Run_page<Moving_mesh_3>);
extern template void print_summary(const Tracker_2&);
extern template void print_summary(const Tracker_3&);

}  // namespace annulus::cli
