// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/reproduction/records.h>

#include <support/catch.h>

#include <nlohmann/json.hpp>

#include <string>

using namespace annulus;

namespace {

Benchmark_record small() {
    Benchmark_record benchmark;
    benchmark.name = "race";
    Contender_record contender;
    contender.name = "tolerances";
    contender.step = {1, 2};
    contender.seconds = {0.1, 0.2};
    for (auto list : {&Contender_record::asked, &Contender_record::failed, &Contender_record::requeued,
                      &Contender_record::changed, &Contender_record::evaluated})
        contender.*list = {3, 4};
    contender.streaks = {7, 6, 5, 4, 3, 2, 1};
    benchmark.contenders = {contender};
    Width_record widths;
    widths.edges = {0, 1, 2};
    widths.counts = {7, 8};
    benchmark.widths = {widths};
    Degeneracy_count_record count;
    count.below = {0, 1};
    count.thresholds = {1e-6, 1e-3};
    benchmark.degeneracies = {count};
    Stability_record stability;
    stability.edges = {0, 1, 2};
    stability.counts = {5, 6};
    stability.median = stability.most = {0.25, 0.5};
    benchmark.stabilities = {stability};
    Picture_record picture;
    picture.x = {0, 1};
    picture.y = {1, 0};
    benchmark.pictures = {picture};
    return benchmark;
}

/// Removes one element of every list of numbers in turn; returns the number of lists.
int without_one(const nlohmann::json& whole, const nlohmann::json::json_pointer& at) {
    int lists = 0;
    const nlohmann::json& here = whole.at(at);
    if (here.is_array() && !here.empty() && here.front().is_number()) {
        nlohmann::json damaged = whole;
        damaged.at(at).erase(0);
        CAPTURE(at.to_string());
        CHECK_THROWS_AS(parse_benchmark(damaged.dump()), Error);
        return 1;
    }
    if (here.is_array())
        for (std::size_t i = 0; i < here.size(); ++i) lists += without_one(whole, at / i);
    if (here.is_object())
        for (const auto& [key, value] : here.items()) lists += without_one(whole, at / key);
    return lists;
}

}  // namespace

TEST_CASE("A part of a reproduction comes back as it was, and is refused where it is damaged") {
    const std::string text = benchmark_text(small());
    CHECK(benchmark_text(parse_benchmark(text)) == text);
    CHECK(without_one(nlohmann::json::parse(text), nlohmann::json::json_pointer("")) == 18);
    for (std::size_t cut = 0; cut + 2 < text.size(); cut += 7)
        CHECK_THROWS_AS(parse_benchmark(text.substr(0, cut)), Error);
    for (const char* other : {"", "3", "[]", "{}", "{\"name\": 3}"}) CHECK_THROWS_AS(parse_benchmark(other), Error);
}
