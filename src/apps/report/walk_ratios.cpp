// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/walk_ratios.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace annulus::inline v1 {

namespace {

// Copied from bench/RESULTS.md; tests/tool/test_advise_gain.py compares them.
constexpr std::array<Walk_ratio, 10> walks_2{{{1e-6, 97.7},
                                              {1e-5, 75.5},
                                              {1e-4, 43.34},
                                              {1e-3, 10.61},
                                              {3e-3, 10.28},
                                              {1e-2, 9.71},
                                              {3e-2, 6.79},
                                              {0.1, 1.76},
                                              {0.3, 2.06},
                                              {1, 2.19}}};
constexpr std::array<Walk_ratio, 10> walks_3{{{1e-6, 483.43},
                                              {1e-5, 175.12},
                                              {1e-4, 36.3},
                                              {1e-3, 24.59},
                                              {3e-3, 18.97},
                                              {1e-2, 10.04},
                                              {3e-2, 5.07},
                                              {0.1, 2.75},
                                              {0.3, 2.45},
                                              {1, 2.95}}};

double between(double x, double x0, double x1, double y0, double y1) {
    const double share = (std::log(x) - std::log(x0)) / (std::log(x1) - std::log(x0));
    return std::exp(std::log(y0) + share * (std::log(y1) - std::log(y0)));
}

}  // namespace

std::span<const Walk_ratio> walk_ratios(int d) { return d == 2 ? std::span(walks_2) : std::span(walks_3); }

double walk_pace(int d, double mean_displacement) {
    // The mean length of a vector of d Gaussians is sqrt(pi / 2) in 2D and sqrt(8 / pi) in 3D.
    const double mean = d == 2 ? std::sqrt(std::numbers::pi / 4) : std::sqrt(8 / (3 * std::numbers::pi));
    return mean_displacement / mean;
}

double walk_ratio(int d, double s) {
    const auto rows = walk_ratios(d);
    if (!(s > rows.front().s)) return rows.front().ratio;
    for (std::size_t i = 1; i < rows.size(); ++i)
        if (s < rows[i].s) return between(s, rows[i - 1].s, rows[i].s, rows[i - 1].ratio, rows[i].ratio);
    return rows.back().ratio;
}

double walk_gain(int d, double s) { return walk_ratio(d, s) / walk_ratios(d).back().ratio; }

double walk_pace_of_gain(int d, double gain) {
    const auto rows = walk_ratios(d);
    const double ratio = gain * rows.back().ratio;
    std::size_t i = 1;
    while (i + 1 < rows.size() && rows[i].ratio >= ratio) ++i;
    return between(ratio, rows[i - 1].ratio, rows[i].ratio, rows[i - 1].s, rows[i].s);
}

}  // namespace annulus::inline v1
