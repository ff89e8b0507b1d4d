// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Counts of samples in bins, and the smallest and largest sample, in the unit of the samples.
///
/// Bins are half open, [edge(i), edge(i+1)), but the last one, which is closed. Samples below and above
/// are counted apart; NaN is no sample. A bin holds exactly the samples between the doubles that `edges()` shows.
class Histogram {
  public:
    /// Bins of equal width over [lower, upper]. Throws Error(usage) unless lower < upper, both finite, bins > 0.
    [[nodiscard]] static Histogram linear(double lower, double upper, std::size_t bins);

    /// Bins of equal ratio over [lower, upper]; zero and negative samples are underflow. Throws Error(usage) unless
    /// 0 < lower < upper < infinity, bins > 0.
    [[nodiscard]] static Histogram log10(double lower, double upper, std::size_t bins);

    /// Counts one sample. O(log bins).
    void add(double sample);
    void add(std::span<const double> samples);

    [[nodiscard]] std::span<const double> edges() const noexcept { return edges_; }
    [[nodiscard]] std::span<const std::uint64_t> counts() const noexcept { return counts_; }
    [[nodiscard]] bool logarithmic() const noexcept { return logarithmic_; }
    [[nodiscard]] std::uint64_t underflow() const noexcept { return underflow_; }
    [[nodiscard]] std::uint64_t overflow() const noexcept { return overflow_; }

    /// Number of samples, those outside the bins included.
    [[nodiscard]] std::uint64_t total() const noexcept { return total_; }
    /// Share of `total()` in bin i; 0 when there are no samples.
    [[nodiscard]] double share(std::size_t i) const;
    /// NaN when there are no samples.
    [[nodiscard]] double min() const noexcept { return min_; }
    [[nodiscard]] double max() const noexcept { return max_; }

  private:
    Histogram(std::vector<double> edges, bool logarithmic);

    std::vector<double> edges_;
    std::vector<std::uint64_t> counts_;
    bool logarithmic_;
    std::uint64_t underflow_ = 0;
    std::uint64_t overflow_ = 0;
    std::uint64_t total_ = 0;
    double min_;
    double max_;
};

/// Quantiles of samples by linear interpolation between order statistics (Hyndman and Fan's type 7): one answer for
/// each probability. Samples are taken by value and sorted, O(n log n). Throws Error(usage) when a probability is
/// outside [0, 1], Error(too_few) without samples, Error(not_finite) when a sample is NaN.
[[nodiscard]] std::vector<double> quantiles(std::vector<double> samples, std::span<const double> probabilities);

}  // namespace annulus::inline v1
