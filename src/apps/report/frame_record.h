// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/report.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace annulus::inline v1 {

/// Results for one frame of a run, in the caller's units; results that were not requested are absent.
struct Frame_record {
    struct Neighbour_pairs {
        std::uint64_t made = 0, broken = 0;
    };
    /// Voronoi cells that are bounded, with a clip those that reach it, of which the part in it counts. Neighbours are
    /// those of cells that a clip does not cut. Numbers are absent where there are no such cells.
    struct Voronoi {
        std::uint64_t bounded = 0, unbounded = 0;
        std::uint64_t whole = 0;                                             ///< of the bounded ones, not cut by a clip
        std::optional<double> volume_low{}, volume_median{}, volume_high{};  ///< 5 %, half and 95 % are smaller
        std::optional<double> neighbours_mean{};
        std::optional<double> hexagons{};  ///< share of cells with six neighbours
    };

    std::uint64_t number = 0;
    std::uint64_t points = 0;
    std::optional<Neighbour_pairs> pairs{};
    std::optional<Voronoi> voronoi{};
};

/// Curves over the frames, of values that are present and not constant; on logarithmic scales where they are positive
/// and span more than a factor of 30. With `steps` also those of the run's steps: displacements, flips.
/// `note` stands below the curves of Voronoi cells.
[[nodiscard]] std::vector<Figure> frame_figures(const std::vector<Frame_record>& frames, const Run_record& run,
                                                bool steps, std::string note = {});

}  // namespace annulus::inline v1
