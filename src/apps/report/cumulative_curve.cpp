// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/cumulative_curve.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// Quantiles that have one value, and the percentages of the least and the greatest of them.
struct Step {
    double value = 0, from = 0, to = 0;
};

/// The steps in [lower, upper), where the percentage goes from `from` to `to`; the last bin has its upper edge, too.
std::vector<Step> steps_between(std::span<const double> quantiles, double lower, double upper, bool last, double from,
                                double to) {
    std::vector<Step> steps;
    const auto in_bin = [&](double x) { return x >= lower && (x < upper || (last && x == upper)); };
    for (std::size_t k = 0; k < quantiles.size(); ++k) {
        if (!in_bin(quantiles[k])) continue;
        const double share = std::clamp(100 * Distribution::probabilities[k], from, to);
        if (!steps.empty() && steps.back().value == quantiles[k]) steps.back().to = share;
        else steps.push_back({quantiles[k], share, share});
    }
    // Where all quantiles of a bin have one value, all its samples are drawn there.
    if (steps.size() == 1 && steps[0].from < steps[0].to) steps[0] = {steps[0].value, from, to};
    return steps;
}

}  // namespace

Series cumulative_curve(std::string name, const Binned& samples, std::span<const double> quantiles,
                        double least_share) {
    Series s{std::move(name), {}, {}};
    const auto percentage = [&](std::uint64_t n) {
        return 100 * static_cast<double>(n) / static_cast<double>(samples.total);
    };
    const auto add = [&](double x, double y) {
        y = std::max(y, least_share);
        if (!s.x.empty() && s.x.back() == x && s.y.back() == y) return;
        s.x.push_back(x);
        s.y.push_back(y);
    };
    const auto filled = [](std::uint64_t n) { return n > 0; };
    const auto begin = samples.counts.begin(), end = samples.counts.end();
    const auto first = static_cast<std::size_t>(std::find_if(begin, end, filled) - begin);
    std::uint64_t below = samples.below;
    std::uint64_t binned = 0;
    for (const std::uint64_t n : samples.counts) binned += n;
    for (std::size_t i = first; i < samples.counts.size() && below < samples.below + binned; ++i) {
        const double from = percentage(below);
        below += samples.counts[i];
        const double to = percentage(below), lower = samples.edges[i], upper = samples.edges[i + 1];
        const auto steps = steps_between(quantiles, lower, upper, i + 1 == samples.counts.size(), from, to);
        const bool starts = i == first && from == 0 && !steps.empty();  // at the least sample, not at the edge
        if (!starts) add(lower, from);
        for (const Step& step : steps) {
            add(step.value, step.from);
            add(step.value, step.to);
        }
        add(upper, to);
    }
    return s;
}

void give_room(Plot& plot) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const Series& curve : plot.series)
        for (const double value : curve.x) {
            least = std::min(least, value);
            most = std::max(most, value);
        }
    if (!(least <= most) || most > 10 * least) return;
    const double factor = std::sqrt(10);
    plot.x.lower = least / factor;
    plot.x.upper = most * factor;
}

}  // namespace annulus::inline v1
