// SPDX-License-Identifier: GPL-3.0-or-later
// The audits compared with brute force, on triangulations of up to eight points that were damaged in all possible ways.
#include "../../fuzz/common/audit_case.h"

#include <support/catch.h>

#include <cstdio>
#include <map>
#include <random>

using namespace annulus::oracle;

namespace {

/// Runs `cases` random byte strings as cases. Returns how many the audit passed, by fault.
template <int d>
std::map<std::string, int> compare(int cases) {
    std::mt19937_64 random(annulus::run_seed());
    std::map<std::string, int> met;
    for (int i = 0; i < cases; ++i) {
        // The kind, n, n points, the order of heights, and none to two changes of three to six bytes.
        const std::size_t n = i % 50 == 0 ? random() % 4 : 4 + random() % 5;
        std::vector<std::uint8_t> bytes(3 + d * n + random() % 3 * (3 + random() % 4));
        for (auto& b : bytes) b = static_cast<std::uint8_t>(random() >> 32);
        bytes[1] = static_cast<std::uint8_t>(n);
        if (i % 4 != 0) bytes[0] = static_cast<std::uint8_t>(bytes[0] & 63);  // neither flat nor on a line
        const auto c = decode_audit_case<d>(Bytes(bytes));
        const std::string fault = audit_fault(c);
        if (!fault.empty()) FAIL(fault << "\n" << as_code(c));
        const auto truth = Brute_force<d>(c.points).verdict(c.cells);
        ++met[truth.fault.empty() && c.changes > 0 ? "right although changed" : truth.fault];
    }
    for (const auto& [what, count] : met) std::printf("%6d %s\n", count, what.c_str());
    return met;
}

}  // namespace

TEST_CASE("The audit of the plane says what brute force says", "[audit]") {
    auto met = compare<2>(6000);
    for (const char* what :
         {"", "right although changed", "two points are one", "a cell is not positive", "a sphere is not empty",
          "a point is no vertex", "two cells overlap", "the cells do not fill the hull"})
        CHECK(met[what] > 10);
}

TEST_CASE("The audit of space says what brute force says", "[audit][space]") {
    auto met = compare<3>(4000);
    for (const char* what :
         {"", "right although changed", "two points are one", "a cell is not positive", "a sphere is not empty",
          "a point is no vertex", "two cells overlap", "the cells do not fill the hull"})
        CHECK(met[what] > 10);
}

TEST_CASE("Brute force accepts what is right and nothing else", "[audit]") {
    const std::vector<Grid_point<2>> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const auto of_square = [&](const std::vector<Cell_of<2>>& cells) { return Brute_force<2>(square).verdict(cells); };
    CHECK(of_square({{0, 1, 2}, {0, 2, 3}}).fault.empty());
    CHECK(of_square({{0, 1, 2}, {0, 2, 3}}).degenerate == 1);
    CHECK(of_square({{0, 1, 3}, {1, 2, 3}}).fault.empty());
    CHECK(of_square({{0, 1, 2}}).fault == "a point is no vertex");
    CHECK(of_square({{0, 1, 2}, {0, 1, 3}}).fault == "two cells overlap");
    CHECK(of_square({{0, 2, 1}, {0, 2, 3}}).fault == "a cell is not positive");
    CHECK(of_square({}).fault != "");
    // A bow tie of five points: every cell right, a gap between.
    const Brute_force<2> five({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 1}});
    CHECK(five.verdict({{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}).fault.empty());
    CHECK(five.verdict({{0, 1, 4}, {2, 3, 4}}).fault == "the cells do not fill the hull");
    // A cube in two halves whose diagonals cross on their common face: nothing overlaps and nothing is left out.
    const std::vector<Grid_point<3>> prism{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
    const Brute_force<3> two_pyramids(prism);
    CHECK(two_pyramids.verdict({{0, 1, 2, 4}, {0, 2, 3, 4}, {2, 1, 0, 5}, {3, 2, 0, 5}}).fault.empty());
    const std::vector<Cell_of<3>> crossed{{0, 1, 2, 4}, {0, 2, 3, 4}, {3, 1, 0, 5}, {3, 2, 1, 5}};
    CHECK(two_pyramids.verdict(crossed).fault == "cells do not meet facet to facet");
    CHECK(audit_fault(Audit_case<3>{prism, crossed, 1, 0, 1}).empty());
}
