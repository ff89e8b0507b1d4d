// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_mesh.h>
#include <annulus/report/report.h>
#include <annulus/report/run_record.h>

#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace annulus::cli {

/// Did what is reported change the cells of the triangulation?
[[nodiscard]] inline bool changes_cells(const Move_report& r) {
    return r.flips + r.moves.reinserted + r.moves.rebuilt + r.moves.flipped > 0;
}

/// Of a motion whose end is not known when it begins.
inline constexpr std::uint64_t unknown_iterations = std::numeric_limits<std::uint64_t>::max();

/// One strategy following a motion: its triangulation (a Moving_mesh), what it did, and what was measured on the way.
template <class Moving>
class Tracker {
  public:
    static constexpr int d = Moving::dimension_of_space;
    /// Lengths are recorded in units of `spacing`. `iterations` decides where measurements are taken: at the first
    /// 20, then about 25 a decade, and the last. Construction and the first tolerances are timed apart from the
    /// steps, whatever the strategy.
    Tracker(std::string name, std::span<const Coordinates<d>> points, const Options& options, double spacing,
            std::uint64_t iterations, std::uint64_t audit_every, bool measure);

    /// How many iterations there are, where that was unknown: told before the last one.
    void ends_after(std::uint64_t iterations) { iterations_ = iterations; }
    /// From now on only the last step is kept: memory then does not depend on how many there are.
    void forget_steps() { keeps_steps_ = false; }

    /// What was made of the file that the points are from.
    void input(Input_record input) { record_.input = std::move(input); }

    /// Told what each call of the triangulation reports, and which vertex it inserted, or `none`.
    using Listener = std::function<void(const Move_report& report, Index arrived)>;
    void listen(Listener listener) { listener_ = std::move(listener); }

    /// Follows one time step. Motion seconds and displacement are what the motion says of itself.
    void step(std::span<const Coordinates<d>> x, double motion_seconds, double displacement_mean,
              double displacement_max);
    /// Follows one time step in which some vertices leave, the others move to x (by index), and then some arrive:
    /// removals, one move_all, insertions. Returns the indices of those that arrived. Throws what the triangulation
    /// throws.
    std::vector<Index> follow(std::span<const Index> leave, std::span<const Coordinates<d>> x,
                              std::span<const Coordinates<d>> arrive, double motion_seconds, double displacement_mean,
                              double displacement_max);
    /// What the mesh was before the first step, and is after the last one.
    void mesh_before(Mesh_step mesh) { record_.mesh_before = std::move(mesh); }
    void mesh_after(Mesh_step mesh) { record_.steps.back().mesh = std::move(mesh); }
    /// Adds to the motion's time of the last step.
    void add_motion(double seconds);
    /// Fills in what is known only at the end.
    void finish(const std::string& command, std::uint64_t seed, double total_seconds);

    [[nodiscard]] const Moving& triangulation() const { return dt_; }
    [[nodiscard]] const Run_record& record() const { return record_; }
    [[nodiscard]] const std::vector<Width_distribution>& widths() const { return widths_; }
    [[nodiscard]] const std::string& first_fault() const { return first_fault_; }
    [[nodiscard]] const Move_report& totals() const { return totals_; }
    /// Share of all moves so far that were within tolerance.
    [[nodiscard]] double share_within() const;
    /// Did the last step change cells?
    [[nodiscard]] bool cells_changed() const { return cells_changed_; }
    /// Cells in one order of their vertices, sorted: equal for equal triangulations.
    [[nodiscard]] std::vector<std::array<Index, static_cast<std::size_t>(d) + 1>> canonical_cells() const;

  private:
    [[nodiscard]] bool measured_at(std::uint64_t iteration) const;
    void audit();
    void record_step(const Move_report& report, double seconds, double motion_seconds, double displacement_mean,
                     double displacement_max);

    void hear(Move_report& report, Index arrived);

    std::chrono::steady_clock::time_point begun_;  // before the triangulation is built
    Moving dt_;
    Listener listener_;
    Run_record record_;
    Move_report totals_;
    std::vector<Width_distribution> widths_;
    std::string first_fault_;
    double spacing_;
    std::uint64_t iterations_;
    std::uint64_t audit_every_;
    bool measure_;
    bool keeps_steps_ = true;
    bool cells_changed_ = true;
};

extern template class Tracker<Moving_mesh_2>;
extern template class Tracker<Moving_mesh_3>;

using Tracker_2 = Tracker<Moving_mesh_2>;
using Tracker_3 = Tracker<Moving_mesh_3>;

/// The triangulation as a picture for the report.
[[nodiscard]] Picture picture_of(const Moving_mesh_2& dt, std::string caption);

}  // namespace annulus::cli
