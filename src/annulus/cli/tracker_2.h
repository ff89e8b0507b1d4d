// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/io/report.h>
#include <annulus/io/run_record.h>
#include <annulus/moving_delaunay_2.h>

#include <string>
#include <vector>

namespace annulus::cli {

/// One strategy following a motion: its triangulation, what it did, and what was measured on the way.
class Tracker_2 {
  public:
    /// Lengths are recorded in units of `spacing`. `iterations` decides where measurements are taken: at the first 20,
    /// then about 25 a decade, and the last. The precomputation of tolerances is timed as part of `triangulation`.
    Tracker_2(std::string name, std::span<const Coordinates<2>> points, const Options& options, double spacing,
              std::uint64_t iterations, std::uint64_t audit_every, bool measure);

    /// Follows one timestamp. Motion seconds and displacement are what the motion says of itself.
    void step(std::span<const Coordinates<2>> x, double motion_seconds, double displacement_mean,
              double displacement_max);
    /// Fills in what is known only at the end.
    void finish(const std::string& command, std::uint64_t seed, double total_seconds);

    [[nodiscard]] const Moving_delaunay_2& triangulation() const { return dt_; }
    [[nodiscard]] const Run_record& record() const { return record_; }
    [[nodiscard]] const std::vector<Width_distribution>& widths() const { return widths_; }
    [[nodiscard]] const std::string& first_fault() const { return first_fault_; }
    [[nodiscard]] const Move_report& totals() const { return totals_; }
    /// Share of all moves so far that were within tolerance.
    [[nodiscard]] double share_within() const;
    /// Did the last step change cells?
    [[nodiscard]] bool cells_changed() const { return cells_changed_; }
    /// Cells with the least index first, sorted: equal for equal triangulations.
    [[nodiscard]] std::vector<std::array<Index, 3>> canonical_cells() const;

  private:
    [[nodiscard]] bool measured_at(std::uint64_t iteration) const;
    void audit();

    Moving_delaunay_2 dt_;
    Run_record record_;
    Move_report totals_;
    std::vector<Width_distribution> widths_;
    std::string first_fault_;
    double spacing_;
    std::uint64_t iterations_;
    std::uint64_t audit_every_;
    bool measure_;
    bool cells_changed_ = true;
};

/// The triangulation as a picture for the report.
[[nodiscard]] Picture picture_of(const Moving_delaunay_2& dt, std::string caption);

}  // namespace annulus::cli
