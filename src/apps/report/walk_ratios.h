// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace annulus::inline v1 {

/// One row of a table of random walks in bench/RESULTS.md.
struct Walk_ratio {
    double s;      ///< root mean square displacement per step, in mean spacings
    double ratio;  ///< the time of CGAL's insertion of all points over that of `auto` (column `Moving_mesh`)
};

/// The source of the rows, for printing.
inline constexpr const char* walk_ratios_source = "bench/RESULTS.md, random walks of uniform points";

/// The rows of dimension d, by ascending s. Precondition: d is 2 or 3.
[[nodiscard]] std::span<const Walk_ratio> walk_ratios(int d);

/// The s of a random walk whose mean displacement per step is this: coordinates are Gaussian with the standard
/// deviation s / sqrt(d). Both in mean spacings.
[[nodiscard]] double walk_pace(int d, double mean_displacement);

/// The ratio at s, interpolated linearly in the logarithms of both; that of the first or last row beyond them.
[[nodiscard]] double walk_ratio(int d, double s);

/// The ratio over that of the last row, at which every step is rebuilt: how much faster than rebuilding by this library
/// `auto` is expected to be.
[[nodiscard]] double walk_gain(int d, double s);

/// The largest s, from below, at which the gain is still `gain`. Precondition: 1 < gain, less than that of the first
/// row.
[[nodiscard]] double walk_pace_of_gain(int d, double gain);

}  // namespace annulus::inline v1
