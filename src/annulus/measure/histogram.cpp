// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/degeneracy.h>
#include <annulus/error.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void require(bool good, const char* what) {
    if (!good) throw Error(Error_code::usage, what);
}

/// Rounded edges may fall out of order when the range is a few ulps wide; the bins would then not partition it.
void require_increasing(const std::vector<double>& edges) {
    require(std::adjacent_find(edges.begin(), edges.end(), std::greater_equal<>()) == edges.end(),
            "histogram: more bins than the range has doubles to separate");
}

}  // namespace

Histogram::Histogram(std::vector<double> edges, bool logarithmic)
    : edges_(std::move(edges)), counts_(edges_.size() - 1), logarithmic_(logarithmic), min_(nan), max_(nan) {
    require_increasing(edges_);
}

Histogram Histogram::linear(double lower, double upper, std::size_t bins) {
    require(std::isfinite(lower) && std::isfinite(upper) && lower < upper, "histogram: needs finite lower < upper");
    require(bins > 0, "histogram: needs at least one bin");
    std::vector<double> edges(bins + 1);
    for (std::size_t i = 0; i <= bins; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(bins);
        edges[i] = lower * (1 - t) + upper * t;
    }
    edges.front() = lower;
    edges.back() = upper;
    return {std::move(edges), false};
}

Histogram Histogram::log10(double lower, double upper, std::size_t bins) {
    require(lower > 0 && std::isfinite(upper) && lower < upper, "histogram: needs 0 < lower < upper, finite");
    require(bins > 0, "histogram: needs at least one bin");
    const double first = std::log10(lower);
    const double last = std::log10(upper);
    std::vector<double> edges(bins + 1);
    for (std::size_t i = 0; i <= bins; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(bins);
        edges[i] = std::pow(10., first * (1 - t) + last * t);
    }
    edges.front() = lower;
    edges.back() = upper;
    return {std::move(edges), true};
}

void Histogram::add(double sample) {
    if (std::isnan(sample)) return;
    min_ = total_ == 0 ? sample : std::min(min_, sample);
    max_ = total_ == 0 ? sample : std::max(max_, sample);
    ++total_;
    if (sample < edges_.front()) {
        ++underflow_;
    } else if (sample > edges_.back()) {
        ++overflow_;
    } else {
        // upper_bound over the inner edges only, so that a sample equal to the last edge lands in the last bin.
        const auto bin = std::upper_bound(edges_.begin() + 1, edges_.end() - 1, sample) - (edges_.begin() + 1);
        ++counts_[static_cast<std::size_t>(bin)];
    }
}

void Histogram::add(std::span<const double> samples) {
    for (const double s : samples) add(s);
}

double Histogram::share(std::size_t i) const {
    return total_ == 0 ? 0. : static_cast<double>(counts_.at(i)) / static_cast<double>(total_);
}

std::vector<double> quantiles(std::vector<double> samples, std::span<const double> probabilities) {
    if (samples.empty()) throw Error(Error_code::too_few, "quantiles: no samples");
    if (std::any_of(samples.begin(), samples.end(), [](double s) { return std::isnan(s); }))
        throw Error(Error_code::not_finite, "quantiles: a sample is NaN");
    std::sort(samples.begin(), samples.end());
    std::vector<double> result;
    result.reserve(probabilities.size());
    for (const double p : probabilities) {
        require(p >= 0 && p <= 1, "quantiles: a probability is outside [0, 1]");
        const double rank = p * static_cast<double>(samples.size() - 1);
        const auto below = static_cast<std::size_t>(rank);
        const std::size_t above = std::min(below + 1, samples.size() - 1);
        const double t = rank - std::floor(rank);
        // The test keeps an infinite neighbour of weight zero from turning the answer into NaN.
        result.push_back(t == 0 || samples[below] == samples[above] ? samples[below]
                                                                    : samples[below] * (1 - t) + samples[above] * t);
    }
    return result;
}

}  // namespace annulus::inline v1
