// SPDX-License-Identifier: GPL-3.0-or-later
// All point sets on a small grid, where nearly everything is degenerate: every set of four to six points of a 3 x 3 and
// of a 2 x 2 x 3 grid is built, audited and compared with brute force, and moved to others.
#include <common/brute_force.h>

#include <support/catch.h>
#include <support/viewed_mesh.h>

#include <bit>
#include <span>

using namespace annulus;
using namespace annulus::oracle;

namespace {

template <int d>
using Moving = testing::Viewed_mesh<d>;

std::vector<Grid_point<2>> grid_of(std::integral_constant<int, 2>) {
    std::vector<Grid_point<2>> x;
    for (int i = 0; i < 9; ++i) x.push_back({i / 3, i % 3});
    return x;
}
std::vector<Grid_point<3>> grid_of(std::integral_constant<int, 3>) {
    std::vector<Grid_point<3>> x;
    for (int i = 0; i < 12; ++i) x.push_back({i / 6, i / 3 % 2, i % 3});
    return x;
}

/// Every set of k points of the grid, in the grid's order.
template <int d>
std::vector<std::vector<Grid_point<d>>> sets_of(std::size_t k) {
    const auto grid = grid_of(std::integral_constant<int, d>());
    std::vector<std::vector<Grid_point<d>>> sets;
    for (unsigned chosen = 0; chosen < (1U << grid.size()); ++chosen) {
        if (static_cast<std::size_t>(std::popcount(chosen)) != k) continue;
        std::vector<Grid_point<d>> set;
        for (std::size_t i = 0; i < grid.size(); ++i)
            if ((chosen >> i & 1U) != 0) set.push_back(grid[i]);
        sets.push_back(set);
    }
    return sets;
}

template <int d>
std::vector<Coordinates<d>> coordinates(const std::vector<Grid_point<d>>& set) {
    std::vector<Coordinates<d>> x(set.size());
    for (std::size_t i = 0; i < set.size(); ++i) std::copy(set[i].begin(), set[i].end(), x[i].begin());
    return x;
}

template <int d>
std::string as_code(const std::vector<Grid_point<d>>& set) {
    std::string s;
    for (const auto& p : set) {
        s += s.empty() ? "{" : ", {";
        for (const int c : p) s += std::to_string(c) + (&c == &p.back() ? "}" : ",");
    }
    return s;
}

/// Empty, or the fault where the vertices are at `set`.
template <int d>
std::string fault_at(const Moving<d>& dt, const std::vector<Grid_point<d>>& set) {
    const Brute_verdict truth = Brute_force<d>(set).verdict(dt.audit_input().cells);
    if (!truth.fault.empty()) return truth.fault;
    const Audit_result audit = dt.audit();
    if (!audit.delaunay()) return "the audit refuses what is right: " + audit.first_fault;
    if (audit.degenerate_facets != truth.degenerate) return "the audit counts other degenerate facets";
    return {};
}

Options options_of(Strategy strategy) {
    Options o;
    o.strategy = strategy;
    return o;
}

template <int d>
std::size_t build_all() {
    std::size_t count = 0;
    for (std::size_t k = 4; k <= 6; ++k)
        for (const auto& set : sets_of<d>(k))
            for (const Strategy strategy : {Strategy::tolerances, Strategy::rebuild}) {
                const Moving<d> dt(std::span<const Coordinates<d>>(coordinates<d>(set)), options_of(strategy));
                ++count;
                if (const std::string fault = fault_at<d>(dt, set); !fault.empty())
                    FAIL(fault << " under " << name_of(strategy) << ": " << as_code<d>(set));
            }
    return count;
}

/// One object moves from each of some sets to each other one, and back; every `stride`-th set of k points.
template <int d>
std::size_t move_between_all(std::size_t k, std::size_t stride, Strategy strategy) {
    const auto all = sets_of<d>(k);
    std::vector<std::vector<Grid_point<d>>> sets;
    for (std::size_t i = k % stride; i < all.size(); i += stride) sets.push_back(all[i]);
    Moving<d> dt(std::span<const Coordinates<d>>(coordinates<d>(sets[0])), options_of(strategy));
    std::size_t count = 0;
    const std::vector<Grid_point<d>>* before = &sets[0];
    const auto go = [&](const std::vector<Grid_point<d>>& set) {
        dt.move_all(std::span<const Coordinates<d>>(coordinates<d>(set)));
        ++count;
        if (const std::string fault = fault_at<d>(dt, set); !fault.empty())
            FAIL(fault << " under " << name_of(strategy) << ", moved from " << as_code<d>(*before) << " to "
                       << as_code<d>(set));
        before = &set;
    };
    for (std::size_t i = 0; i < sets.size(); ++i) {
        go(sets[i]);
        for (std::size_t j = 0; j < i; ++j) {
            go(sets[j]);
            go(sets[i]);
        }
    }
    return count;
}

/// The vertices of a set are permuted in every way.
template <int d>
std::size_t permute_all(std::size_t k, std::size_t stride, Strategy strategy) {
    const auto sets = sets_of<d>(k);
    std::size_t count = 0;
    for (std::size_t i = k % stride; i < sets.size(); i += stride) {
        auto set = sets[i];
        Moving<d> dt(std::span<const Coordinates<d>>(coordinates<d>(set)), options_of(strategy));
        while (std::next_permutation(set.begin(), set.end())) {
            dt.move_all(std::span<const Coordinates<d>>(coordinates<d>(set)));
            ++count;
            if (const std::string fault = fault_at<d>(dt, set); !fault.empty())
                FAIL(fault << " under " << name_of(strategy) << ": " << as_code<d>(set));
        }
    }
    return count;
}

}  // namespace

TEST_CASE("Every set of four to six points of a 3 x 3 grid is triangulated as brute force would have it",
          "[exhaustive]") {
    CHECK(build_all<2>() == 2 * (126 + 126 + 84));
}

TEST_CASE("Every set of four to six points of a 2 x 2 x 3 grid is triangulated as brute force would have it",
          "[exhaustive][space]") {
    CHECK(build_all<3>() == 2 * (495 + 792 + 924));
}

TEST_CASE("Moves between all sets of a 3 x 3 grid end in what brute force would have", "[exhaustive]") {
    CHECK(move_between_all<2>(4, 1, Strategy::tolerances) == 126 * 126);
    CHECK(move_between_all<2>(5, 3, Strategy::tolerances) == 42 * 42);
    CHECK(move_between_all<2>(6, 3, Strategy::tolerances_each) == 28 * 28);
    CHECK(move_between_all<2>(5, 5, Strategy::rebuild) == 26 * 26);
    CHECK(permute_all<2>(4, 2, Strategy::tolerances) > 1000);
    CHECK(permute_all<2>(5, 17, Strategy::tolerances_each) > 500);
}

TEST_CASE("Moves between sets of a 2 x 2 x 3 grid end in what brute force would have", "[exhaustive][space]") {
    CHECK(move_between_all<3>(4, 17, Strategy::tolerances) > 600);
    CHECK(move_between_all<3>(5, 31, Strategy::tolerances) > 600);
    CHECK(move_between_all<3>(6, 37, Strategy::tolerances) > 600);
    CHECK(move_between_all<3>(5, 61, Strategy::tolerances_each) > 100);
    CHECK(permute_all<3>(4, 40, Strategy::tolerances) > 200);
    CHECK(permute_all<3>(5, 200, Strategy::tolerances) > 300);
}
