// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/svg_plot.h>

#include <cstdint>
#include <span>
#include <string>

namespace annulus::inline v1 {

/// Samples in bins: counts, and how many are below the first edge and in all.
struct Binned {
    std::span<const double> edges{};  ///< one more than bins
    std::span<const std::uint64_t> counts{};
    std::uint64_t below = 0;
    std::uint64_t total = 0;
};

/// The percentage of the samples below x, from the bin with the first sample to the upper edge of that with the last.
/// At each edge it is exact. Within a bin it goes through the quantiles there, if there are any (at
/// Distribution::probabilities, ascending; or none): up at a value that several of them have, and straight
/// in between. On a logarithmic scale of percentages a curve without samples below its first bin has no point at 0:
/// `least_share` is what stands in its place, for instance that of one sample.
///
/// Empty where no sample is in a bin. O(bins + quantiles).
[[nodiscard]] Series cumulative_curve(std::string name, const Binned& samples, std::span<const double> quantiles,
                                      double least_share);

/// Makes the range of a logarithmic x axis a decade or more, so that samples in one bin are a step and no slope, and
/// the axis has two ticks or more. Nothing where there are no points.
void give_room(Plot& plot);

}  // namespace annulus::inline v1
