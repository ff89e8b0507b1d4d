// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_mesh.h>
#include <apps/cli/boxed_mesh.h>
#include <apps/cli/stopwatch.h>
#include <apps/report/report.h>
#include <apps/report/run_record.h>

#include <concepts>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace annulus::inline v1::cli {

/// Whether the reported call changed the cells of the triangulation.
[[nodiscard]] inline bool changes_cells(const Move_result& r) {
    return r.statistics.flips + r.moves.reinserted + r.moves.rebuilt + r.moves.flipped > 0;
}

/// The number of iterations of a motion whose end is not known at its beginning.
inline constexpr std::uint64_t unknown_iterations = std::numeric_limits<std::uint64_t>::max();

/// How far the vertices moved in a step, in the unit of the points.
struct Displacement {
    double mean = 0, max = 0;
};

/// Whether single vertices of this triangulation can be inserted and removed: of a Moving_mesh, not of a Boxed_mesh.
template <class Moving>
concept Open_mesh = std::same_as<Moving, Moving_mesh<Moving::dimension_of_space>>;

/// One strategy that follows a motion: its triangulation (a Moving_mesh or Boxed_mesh), what it did, and the
/// measurements.
template <class Moving>
class Run_tracker {
  public:
    static constexpr int d = Moving::dimension_of_space;
    /// For the triangulation that `make` returns. Lengths are recorded in units of `spacing`. `iterations` decides
    /// where measurements are taken: at the first 20, then about 25 a decade, and the last. Construction and the first
    /// tolerances are timed apart from the steps, whatever the strategy.
    Run_tracker(std::string name, const std::function<Moving()>& make, const Options& options, double spacing,
                std::uint64_t iterations, std::uint64_t audit_every, bool measure);

    /// Sets the number of iterations if it was unknown. To be called before the last one.
    void ends_after(std::uint64_t iterations) { iterations_ = iterations; }
    /// From now on only the last step is kept, so that memory does not depend on the number of steps.
    void forget_steps() { keeps_steps_ = false; }

    /// Sets how the file with the points was interpreted.
    void input(Input_record input) { record_.input = std::move(input); }

    /// Sets to what the Voronoi cells of the frames are clipped.
    void clip(Clip_record clip) { record_.clip = std::move(clip); }

    /// Called with the report of each call of the triangulation, and with the vertex that it inserted, or `none`.
    using Listener = std::function<void(const Move_result& report, Index arrived)>;
    void listen(Listener listener) { listener_ = std::move(listener); }

    /// Follows one time step that is a call of the triangulation. The motion measures its seconds and displacements
    /// itself. `way` is read after the call.
    void step(const std::function<Move_result(Moving&)>& call, double motion_seconds, const Displacement& way);
    /// Set the quality of the mesh before the first step, and after the last step.
    void mesh_before(Mesh_step mesh) { record_.mesh_before = std::move(mesh); }
    void mesh_after(Mesh_step mesh) { record_.steps.back().mesh = std::move(mesh); }
    /// The same of a 2D triangulation. Without a step the latter has no effect.
    void plane_before(Plane_step plane) { record_.plane_before = plane; }
    void plane_after(Plane_step plane) {
        if (!record_.steps.empty()) record_.steps.back().plane = plane;
    }
    /// Sets how the volumes of Voronoi cells scatter, before the first step or after the last one so far.
    void volume_scatter(double value) {
        (record_.steps.empty() ? record_.volume_scatter_before : record_.steps.back().volume_scatter) = value;
    }
    /// Sets that the steps are from frame to frame of a file.
    void note_replay() { record_.replayed = true; }
    /// Sets the cells with the least dihedral angles at the end.
    void worst_cells(std::vector<Worst_cell> cells) { record_.worst = std::move(cells); }
    /// Sets that the last step was no iteration.
    void note_finish() { record_.finished = true; }
    /// Adds to the time of the motion in the last step.
    void add_motion(double seconds);
    /// Completes the record at the end of the run.
    void finish(const std::string& command, std::uint64_t seed, double total_seconds);

    [[nodiscard]] const Moving& triangulation() const { return dt_; }
    [[nodiscard]] int threads() const { return threads_; }
    [[nodiscard]] const Run_record& record() const { return record_; }
    [[nodiscard]] const std::vector<Width_distribution>& widths() const { return widths_; }
    [[nodiscard]] const std::string& first_fault() const { return first_fault_; }
    [[nodiscard]] const Move_result& totals() const { return totals_; }
    /// Share of all moves so far that were within tolerance.
    [[nodiscard]] double share_within() const;
    /// Whether the last step changed cells.
    [[nodiscard]] bool cells_changed() const { return cells_changed_; }

  protected:
    /// For steps of several calls: the triangulation, each call's report and the vertex that it inserted, and the sum.
    [[nodiscard]] Moving& mesh() { return dt_; }
    void hear(Move_result& report, Index arrived);
    void record_step(const Move_result& report, double seconds, double motion_seconds, const Displacement& way);
    void note_changed_cells() { cells_changed_ = true; }

  private:
    [[nodiscard]] bool measured_at(std::uint64_t iteration) const;
    void audit();

    int threads_;
    Stopwatch begun_;  // before the triangulation is built
    Moving dt_;
    Listener listener_;
    Run_record record_;
    Move_result totals_;
    std::vector<Width_distribution> widths_;
    std::string first_fault_;
    double spacing_;
    std::uint64_t iterations_;
    std::uint64_t audit_every_;
    Strategy strategy_;
    bool measure_;
    bool keeps_steps_ = true;
    bool cells_changed_ = true;
};

extern template class Run_tracker<Moving_mesh_2>;
extern template class Run_tracker<Moving_mesh_3>;
extern template class Run_tracker<Boxed_mesh<2>>;
extern template class Run_tracker<Boxed_mesh<3>>;

}  // namespace annulus::inline v1::cli
