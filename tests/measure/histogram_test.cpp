// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/degeneracy.h>
#include <annulus/error.h>

#include <support/catch.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

using namespace annulus;
using annulus::testing::for_all;

TEST_CASE("linear bins are half open but the last") {
    Histogram h = Histogram::linear(0, 1, 4);
    const double inf = std::numeric_limits<double>::infinity();
    h.add(std::vector<double>{0, 0.25, 0.49, 0.75, 1, -1, 1.5, std::nan(""), -inf});
    CHECK(std::vector<std::uint64_t>(h.counts().begin(), h.counts().end()) == std::vector<std::uint64_t>{1, 2, 0, 2});
    CHECK(h.underflow() == 2);
    CHECK(h.overflow() == 1);
    CHECK(h.total() == 8);
    CHECK(h.min() == -inf);
    CHECK(h.max() == 1.5);
    CHECK(h.share(1) == 0.25);
}

TEST_CASE("logarithmic bins have equal ratios, and zero is underflow") {
    Histogram h = Histogram::log10(1e-3, 1e3, 6);
    CHECK(h.logarithmic());
    CHECK(h.edges()[0] == 1e-3);
    CHECK(h.edges()[3] == Approx(1));
    CHECK(h.edges()[6] == 1e3);
    h.add(std::vector<double>{0, -5, 2, 3, 1e3, 1e4});
    CHECK(h.counts()[3] == 2);
    CHECK(h.counts()[5] == 1);
    CHECK(h.underflow() == 2);
    CHECK(h.overflow() == 1);
}

TEST_CASE("a histogram without samples has no least and no greatest") {
    const Histogram h = Histogram::linear(0, 1, 1);
    CHECK(std::isnan(h.min()));
    CHECK(std::isnan(h.max()));
    CHECK(h.share(0) == 0);
}

TEST_CASE("every sample is counted where the edges say") {
    CHECK(for_all("counts match the edges", [] {
        const bool logarithmic = *rc::gen::arbitrary<bool>();
        const auto bins = *rc::gen::inRange<std::size_t>(1, 30);
        Histogram a = logarithmic ? Histogram::log10(1e-3, 70, bins) : Histogram::linear(-0.3, 70, bins);
        std::vector<double> samples = *rc::gen::arbitrary<std::vector<double>>();
        samples.insert(samples.end(), a.edges().begin(), a.edges().end());
        a.add(samples);
        for (std::size_t i = 0; i < bins; ++i) {
            const bool last = i + 1 == bins;
            const auto expected = std::count_if(samples.begin(), samples.end(), [&](double s) {
                return s >= a.edges()[i] && (s < a.edges()[i + 1] || (last && s == a.edges()[i + 1]));
            });
            RC_ASSERT(a.counts()[i] == static_cast<std::uint64_t>(expected));
        }
        RC_ASSERT(a.total() == samples.size());
        RC_ASSERT(a.total() == a.underflow() + a.overflow() +
                                   std::accumulate(a.counts().begin(), a.counts().end(), std::uint64_t{0}));
        RC_ASSERT(a.min() == *std::min_element(samples.begin(), samples.end()));
        RC_ASSERT(a.max() == *std::max_element(samples.begin(), samples.end()));
    }));
}

TEST_CASE("histograms that cannot be are refused") {
    const double inf = std::numeric_limits<double>::infinity();
    CHECK_THROWS_AS(Histogram::linear(1, 1, 3), Error);
    CHECK_THROWS_AS(Histogram::linear(0, inf, 3), Error);
    CHECK_THROWS_AS(Histogram::linear(0, 1, 0), Error);
    CHECK_THROWS_AS(Histogram::linear(1, std::nextafter(1, 2), 3), Error);
    CHECK_THROWS_AS(Histogram::log10(0, 1, 3), Error);
}

TEST_CASE("quantiles interpolate between order statistics") {
    const std::vector<double> at = {0, 0.25, 0.5, 1};
    CHECK(quantiles({4, 1, 3, 2}, at) == std::vector<double>{1, 1.75, 2.5, 4});
    CHECK(quantiles({7}, at) == std::vector<double>{7, 7, 7, 7});
    CHECK_THROWS_AS(quantiles({}, at), Error);
    CHECK_THROWS_AS(quantiles({std::nan("")}, at), Error);
    CHECK_THROWS_AS(quantiles({1}, std::vector<double>{1.5}), Error);
}
