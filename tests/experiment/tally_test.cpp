// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/sums.h>
#include <apps/experiment/tally.h>

#include <support/catch.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <random>

using namespace annulus;

namespace {

/// Some of the names, so that a sum has entries that not all tallies have.
Tally some_tally(std::mt19937_64& random) {
    Tally t;
    for (const char* name : {"bicells.total", "bicells.zero", "vertices"})
        if (random() % 3 != 0) t.counts[name] = random() % 1'000'000'000'000;
    for (const char* name : {"theta", "bicells.width"}) {
        if (random() % 3 == 0) continue;
        Bins& b = t.histograms[name];
        b = {random() % 100, random() % 100, std::vector<std::uint64_t>(scale(name).counts().size())};
        for (auto& n : b.in) n = random() % 4 == 0 ? random() % 1000 : 0;
    }
    if (random() % 2 == 0) t.least["bicells.width"] = std::ldexp(static_cast<double>(random() >> 11), -80);
    return t;
}

}  // namespace

TEST_CASE("The sum of tallies does not depend on their order, nor on which were added first") {
    for (int seed = 1; seed <= repeats(300); ++seed) {
        CAPTURE(seed);
        std::mt19937_64 random(static_cast<unsigned>(seed));
        std::vector<Tally> all(random() % 12);
        for (Tally& t : all) t = some_tally(random);
        Tally in_turn;
        for (const Tally& t : all) in_turn += t;
        // Two that are next to each other, wherever they have come to lie, until one is left.
        std::shuffle(all.begin(), all.end(), random);
        while (all.size() > 1) {
            const auto at = static_cast<std::ptrdiff_t>(random() % (all.size() - 1));
            all[static_cast<std::size_t>(at)] += all[static_cast<std::size_t>(at) + 1];
            all.erase(all.begin() + at + 1);
        }
        REQUIRE((all.empty() ? Tally() : all[0]) == in_turn);
    }
}

TEST_CASE("A tally read back from its JSON is the same") {
    for (int seed = 1; seed <= repeats(100); ++seed) {
        CAPTURE(seed);
        std::mt19937_64 random(static_cast<unsigned>(seed));
        const Tally t = some_tally(random);
        const std::string text = tally_json(t).dump();
        REQUIRE(tally_of(nlohmann::ordered_json::parse(text)) == t);
        REQUIRE(tally_json(tally_of(nlohmann::ordered_json::parse(text))).dump() == text);
    }
}

TEST_CASE("Quantiles of bins lie in the bin of the sample") {
    Histogram h = Histogram::linear(0, 10, 10);
    for (int i = 0; i < 100; ++i) h.add(i / 10.0);
    const Bins b = bins_of(h);
    for (const double p : {0.001, 0.25, 0.5, 0.999}) CHECK(std::fabs(quantile(b, h, p) - 10 * p) < 0.2);
    CHECK(std::isnan(quantile(Bins{0, 0, std::vector<std::uint64_t>(10)}, h, 0.5)));
    CHECK(quantile(Bins{5, 0, std::vector<std::uint64_t>(10)}, h, 0.5) == 0);
    CHECK(quantile(Bins{0, 5, std::vector<std::uint64_t>(10)}, h, 0.5) == 10);
}

TEST_CASE("Lines are added by what they have in common but for the seed") {
    Sums sums;
    for (const int seed : {1, 2, 3}) {
        nlohmann::ordered_json line{{"grid", 1}, {"kind", seed == 3 ? "grid" : "uniform"}, {"seed", seed}};
        Tally t;
        t.counts["vertices"] = static_cast<std::uint64_t>(seed);
        line.update(tally_json(t));
        sums.add(line);
    }
    REQUIRE(sums.points().size() == 2);
    CHECK(sums.points()[0].tally.counts.at("vertices") == 3);
    CHECK(sums.points()[1].tally.counts.at("vertices") == 3);
    CHECK_FALSE(sums.points()[0].where.contains("seed"));
}
