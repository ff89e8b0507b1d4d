// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/hard_inputs.h>

#include <support/catch.h>
#include <support/repeats.h>

#include <algorithm>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

using namespace annulus;

namespace {

using Met = std::vector<Hard_input>;

/// Few different points, so that the same set of points occurs often, in several orders and with several keys.
Met some_inputs(std::mt19937_64& random) {
    Met met(random() % 60);
    for (Hard_input& input : met) {
        for (int i = 0; i < 3; ++i) {
            input.coordinates.push_back(static_cast<double>(random() % 3));
            input.coordinates.push_back(0.0);
        }
        input.key = static_cast<double>(random() % 5);
        input.seed = random() % 2;
    }
    return met;
}

/// The hardest input of each set of points, and the hardest of these: by sorting everything.
Met expected(Met met, std::size_t most) {
    std::sort(met.begin(), met.end());
    std::set<std::multiset<std::pair<double, double>>> seen;
    Met kept;
    for (const Hard_input& input : met) {
        std::multiset<std::pair<double, double>> points;
        for (std::size_t i = 0; i < input.coordinates.size(); i += 2)
            points.insert({input.coordinates[i], input.coordinates[i + 1]});
        if (seen.insert(points).second && kept.size() < most) kept.push_back(input);
    }
    return kept;
}

Hard_inputs of(const Met& met, std::size_t most) {
    Hard_inputs hard(most);
    for (const Hard_input& input : met) hard.add(Certificate_name::orientation_2, Stage::exact, input);
    return hard;
}

}  // namespace

TEST_CASE("The hardest inputs kept are those that sorting all of them finds, in any order and however divided") {
    for (int seed = 1; seed <= repeats(500); ++seed) {
        CAPTURE(seed);
        std::mt19937_64 random(static_cast<unsigned>(seed));
        Met met = some_inputs(random);
        const std::size_t most = random() % 8;
        const auto whole = of(expected(met, most), most).json();
        REQUIRE(whole.size() == expected(met, most).size());
        std::shuffle(met.begin(), met.end(), random);
        REQUIRE(of(met, most).json() == whole);
        // Divided and merged; merging only the inputs that a merge reports as kept gives the same.
        const auto cut = met.begin() + static_cast<std::ptrdiff_t>(met.empty() ? 0 : random() % met.size());
        Hard_inputs merged = of(Met(met.begin(), cut), most), journal = of(Met(met.begin(), cut), most);
        journal.merge(merged.merge(of(Met(cut, met.end()), most)));
        REQUIRE(merged.json() == whole);
        REQUIRE(journal.json() == whole);
        Hard_inputs read(most);
        for (const auto& one : merged.json()) read.add(nlohmann::ordered_json::parse(one.dump()));
        REQUIRE(read.json() == whole);
    }
}
