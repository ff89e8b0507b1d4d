// SPDX-License-Identifier: GPL-3.0-or-later
// Cumulative curves of binned samples agree with the samples, and with their quantiles.
#include <annulus/degeneracy.h>
#include <apps/report/cumulative_curve.h>

#include <support/catch.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <algorithm>
#include <vector>

using namespace annulus;
using annulus::testing::for_all;

namespace {

Series curve(const std::vector<double>& samples, double least_share = 0) {
    Distribution d;
    d.histogram.add(samples);
    d.quantiles = quantiles(samples, Distribution::probabilities);
    const Histogram& h = d.histogram;
    return cumulative_curve("", {h.edges(), h.counts(), h.underflow(), h.total()}, d.quantiles, least_share);
}

std::vector<std::pair<double, double>> points(const Series& s) {
    std::vector<std::pair<double, double>> found;
    for (std::size_t i = 0; i < s.x.size(); ++i) found.emplace_back(s.x[i], s.y[i]);
    return found;
}

}  // namespace

TEST_CASE("One value is a step at that value", "[report]") {
    const Series s = curve(std::vector<double>(8, 0.373), 12.5);
    REQUIRE(s.x.size() == 3);
    CHECK(points(s)[0] == std::pair(0.373, 12.5));
    CHECK(points(s)[1] == std::pair(0.373, 100.));
    CHECK((s.x[2] > 0.373 && s.y[2] == 100));
}

TEST_CASE("Two values in bins beside one another are two steps, and zeros are below both", "[report]") {
    std::vector<double> samples(20, 0.);
    samples.insert(samples.end(), 40, 0.561);
    samples.insert(samples.end(), 40, 0.794);
    const auto found = points(curve(samples));
    for (const auto& corner :
         {std::pair(0.561, 20.), std::pair(0.561, 60.), std::pair(0.794, 60.), std::pair(0.794, 100.)})
        CHECK(std::find(found.begin(), found.end(), corner) != found.end());
    CHECK(found.front().second == 20);
}

TEST_CASE("Two values in one bin are two steps, up to where the quantiles are", "[report]") {
    std::vector<double> samples(60, 0.687);
    samples.insert(samples.end(), 40, 0.786);
    const auto found = points(curve(samples));
    CHECK(found[0] == std::pair(0.687, 0.));
    CHECK(found[1] == std::pair(0.687, 50.));  // the greatest quantile there is the median
    CHECK(std::find(found.begin(), found.end(), std::pair(0.786, 75.)) != found.end());
    CHECK(std::find(found.begin(), found.end(), std::pair(0.786, 100.)) != found.end());
}

TEST_CASE("A curve ascends, is right at the edges of bins, and is nowhere off by more than a bin", "[report]") {
    for_all("samples of few values, or of many, 0 among them", [] {
        const auto whole = *rc::gen::nonEmpty(rc::gen::container<std::vector<int>>(rc::gen::inRange(0, 40)));
        std::vector<double> samples;
        for (const int x : whole) samples.push_back(x / 16.);
        const Series s = curve(samples);
        if (*std::max_element(samples.begin(), samples.end()) == 0) {
            RC_ASSERT(s.x.empty());
            return;
        }
        RC_ASSERT(std::is_sorted(s.x.begin(), s.x.end()));
        RC_ASSERT(std::is_sorted(s.y.begin(), s.y.end()));
        RC_ASSERT(s.y.back() == 100);
        const Histogram scale = Distribution().histogram;
        const auto below = [&](double x) {
            return 100. *
                   static_cast<double>(std::count_if(samples.begin(), samples.end(), [&](double v) { return v < x; })) /
                   static_cast<double>(samples.size());
        };
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            const auto upper = std::upper_bound(scale.edges().begin(), scale.edges().end(), s.x[i]);
            RC_ASSERT(s.y[i] >= below(*(upper - 1)));
            RC_ASSERT(s.y[i] <= below(*upper));
        }
    });
}

TEST_CASE("Without quantiles a curve goes from edge to edge", "[report]") {
    const std::vector<double> edges{1, 2, 4, 8, 16};
    const std::vector<std::uint64_t> counts{0, 3, 1, 0};
    const auto found = points(cumulative_curve("", {edges, counts, 0, 4}, {}, 0));
    CHECK(found == std::vector<std::pair<double, double>>{{2, 0}, {4, 75}, {8, 100}});
}
