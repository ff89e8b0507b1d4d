// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/arguments.h>
#include <apps/cli/frame_files.h>
#include <apps/cli/tracker.h>
#include <apps/formats/write_vtu.h>

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

/// The files that `write_run` writes, for --help.
inline constexpr const char* run_files = "summary.json, iterations.csv, final.mesh, final.vtu and report.html";

/// Below curves of Voronoi cells on the page of a run in a domain.
inline constexpr const char* uncut_cells =
    "These are the cells of voronoi.csv, which the domain does not cut: some reach far out of it.";

/// The content of the files and the page of a run that its tracker does not have.
template <class Moving>
struct Run_page {
    using Cell = std::array<Index, static_cast<std::size_t>(Moving::dimension_of_space) + 1>;

    std::string step;  ///< the name of a step in the heading: "Lloyd iteration"
    std::optional<Picture> before{}, after{};
    Film film{};                     ///< instead of these two
    Chosen_cut cut{};                ///< of all these pictures
    std::vector<Picture> voronoi{};  ///< Voronoi cells, of the first and of the last step
    std::vector<Drawing> drawings{};
    std::vector<Figure> figures{};
    std::vector<std::string> notes{};
    std::vector<Cell> cells{};                                 ///< the solid cells, if they have their own order
    std::vector<Vtu_field> point_fields{}, cell_fields{};      ///< additional fields of final.vtu
    std::vector<std::pair<std::string, std::string>> files{};  ///< names and contents of additional files
    Frame_files<Moving>* frames = nullptr;
};

/// Writes summary.json, iterations.csv, final.mesh, final.vtu and report.html of one run, and the additional files of
/// its page, all or none: to --output, or to DIR.partial if the run was interrupted.
template <class Moving>
void write_run(const Common_arguments& arguments, const Run_tracker<Moving>& tracker, Run_page<Moving> page);

/// "8 iterations and a finish", if `step` is "iteration".
[[nodiscard]] std::string steps_of(const Run_record& run, const std::string& step);

/// "500 vertices, 50 Lloyd iterations: NAMES", for the head of a report; `step` is "Lloyd iteration". Of a replayed
/// motion the frames are counted.
[[nodiscard]] std::string title_of(const Run_record& run, const std::string& step, const std::string& names);

/// The caption of the picture before the first iteration, of so many: "Before", or "At the start" where there is none.
[[nodiscard]] inline const char* at_start(std::uint64_t iterations) {
    return iterations > 0 ? "Before" : "At the start, and at the end: there was no iteration";
}

/// Prints one line on standard error: how many steps an interrupted run did, of `steps` if that is known, and the
/// directory with its results.
void say_interrupted(const Common_arguments& arguments, std::uint64_t done_steps,
                     std::optional<std::uint64_t> steps = std::nullopt);

/// Prints the summary at the end of a run.
template <class Moving>
void print_summary(const Run_tracker<Moving>& tracker);

extern template void write_run(const Common_arguments&, const Run_tracker<Moving_mesh_2>&, Run_page<Moving_mesh_2>);
extern template void write_run(const Common_arguments&, const Run_tracker<Moving_mesh_3>&, Run_page<Moving_mesh_3>);
extern template void write_run(const Common_arguments&, const Run_tracker<Boxed_mesh<2>>&, Run_page<Boxed_mesh<2>>);
extern template void write_run(const Common_arguments&, const Run_tracker<Boxed_mesh<3>>&, Run_page<Boxed_mesh<3>>);
extern template void print_summary(const Run_tracker<Boxed_mesh<2>>&);
extern template void print_summary(const Run_tracker<Boxed_mesh<3>>&);
extern template void print_summary(const Run_tracker<Moving_mesh_2>&);
extern template void print_summary(const Run_tracker<Moving_mesh_3>&);

}  // namespace annulus::inline v1::cli
