// SPDX-License-Identifier: GPL-3.0-or-later
// Four cells with offsets at a time are clear where each of them is by itself.
#include <annulus/error.h>
#include <annulus/kernel/periodic_builder.h>
#include <annulus/mesh/clear_cells.h>
#include <annulus/mesh/clear_periodic_cells.h>
#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
struct Cells {
    const Periodic_table<d>& table;
    const Lattice<d>& lattice;
    const std::vector<Coordinates<d>>& x;

    [[nodiscard]] Coordinates<d> at(Image<d> s) const {
        return lattice.place(x[static_cast<std::size_t>(s.vertex)], s.label);
    }
    [[nodiscard]] Image<d> opposite(std::size_t c, std::size_t i) const {
        const Corner_index t = table.twin[c][i];
        return table.image(table.cell_of(t), table.slot_of(t), table.translation(c, i));
    }
    [[nodiscard]] bool is_clear(std::size_t c) const {
        using Sphere = std::conditional_t<d == 2, Circumcircle_2, Circumsphere_3>;
        return [&]<std::size_t... i>(std::index_sequence<i...>) {
            return Sphere(at(table.image(c, i))...).excludes_all(at(opposite(c, i))...);
        }
        (std::make_index_sequence<d + 1>());
    }
    /// Whether all its offsets, and those of what is opposite, are from -1 to 2.
    [[nodiscard]] bool is_near(std::size_t c) const {
        bool near = true;
        for (std::size_t i = 0; i <= d; ++i)
            for (const Image<d> s : {table.image(c, i), opposite(c, i)})
                for (const std::int32_t o : s.label.unpacked()) near = near && o >= -1 && o <= 2;
        return near;
    }
};

struct Counts {
    std::size_t clear = 0, unclear = 0, lifted = 0;
};

/// Moves the points and strains the box of a table, so that some cells are inverted and some facets violated.
template <int d>
Counts check(Periodic_cases& cases, int kind, std::size_t n, double pace, bool on_sites) {
    CAPTURE(d, kind, n, pace, on_sites);
    typename Box<d>::Vectors box = cases.box<d>(kind).vectors();
    const Lattice<d> before(box);
    std::vector<Coordinates<d>> x = cases.points<d>(Box<d>(box), n, 1);
    if (on_sites)
        for (auto& p : x)
            for (double& c : p) c = static_cast<double>(cases.below(4)) / 4;
    for (auto& p : x) p = before.representative(p, 0).place;
    Periodic_table<d> table;
    try {
        Periodic_builder<d>().build(before, x, 1, table);
    } catch (const Error&) {  // duplicate points
        return {};
    }
    for (auto& v : box) v[0] *= 1 + cases.uniform(-pace, pace) / 8;
    const Lattice<d> lattice(box);
    for (auto& p : x)
        for (std::size_t i = 0; i < d; ++i)
            p[i] = std::nearbyint((p[i] + cases.uniform(-pace, pace)) / lattice.grid()[i]) * lattice.grid()[i];
    Clear_periodic_cells<d> clear;
    clear.find(table, lattice, x);
    const std::vector<std::size_t>& rest = clear.rest();
    REQUIRE(std::is_sorted(rest.begin(), rest.end()));
    REQUIRE(std::adjacent_find(rest.begin(), rest.end()) == rest.end());
    const Cells<d> cells{table, lattice, x};
    Counts counts;
    std::size_t untested = 0;
    for (std::size_t c = 0; c < table.size(); ++c) {
        const bool listed = std::binary_search(rest.begin(), rest.end(), c), is = cells.is_clear(c);
        REQUIRE((is || listed));
        ++(is ? counts.clear : counts.unclear);
        if (!listed && cells.opposite(c, 0).label != Offset<d>()) ++counts.lifted;
        if (is && listed && cells.is_near(c)) ++untested;
    }
    REQUIRE(untested <= 6);
    return counts;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Four periodic cells at a time are clear where each is by itself, dimension",
                       "[engine][periodic]", ((int d), d), 2, 3) {
    if (!has_fast_clear_cells()) return;
    Periodic_cases cases(5);
    Counts all;
    for (int k = 0; k < repeats(3); ++k)
        for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
            for (const std::size_t n : {1U, 2U, 5U, 40U, 200U})
                for (const bool on_sites : {false, true}) {
                    const double pace = std::ldexp(1.0, -3 * static_cast<int>(cases.below(16)));
                    const Counts counts = check<d>(cases, kind, n, on_sites ? pace / 4 : pace / 16, on_sites && n < 40);
                    all.clear += counts.clear, all.unclear += counts.unclear, all.lifted += counts.lifted;
                }
    CHECK(all.clear > 1000);
    CHECK(all.unclear > 300);
    CHECK(all.lifted > 50);
}

TEMPLATE_TEST_CASE_SIG("Threads find the same unclear periodic cells, dimension", "[mesh][periodic]", ((int d), d), 2,
                       3) {
    if (!has_fast_clear_cells()) return;
    Periodic_cases cases(6);
    const Lattice<d> lattice(cases.box<d>(4).vectors());
    std::vector<Coordinates<d>> x = cases.points<d>(Box<d>(lattice.given()), d == 2 ? 20'000 : 4'000);
    for (auto& p : x) p = lattice.representative(p, 0).place;
    Periodic_table<d> table;
    Periodic_builder<d>().build(lattice, x, 3, table);
    REQUIRE(table.size() > 3 * 8192 - 8192 / 2);
    for (auto& p : x)
        for (std::size_t i = 0; i < d; ++i)
            p[i] = std::nearbyint((p[i] + cases.uniform(-1e-3, 1e-3)) / lattice.grid()[i]) * lattice.grid()[i];
    Clear_periodic_cells<d> one, more;
    one.find(table, lattice, x);
    CHECK(one.rest().size() > 20);
    CHECK(one.rest().size() < table.size() / 2);
    const Cells<d> cells{table, lattice, x};
    for (std::size_t c = 0; c < table.size(); ++c)
        if (!std::binary_search(one.rest().begin(), one.rest().end(), c)) REQUIRE(cells.is_clear(c));
    for (const int threads : {2, 5}) {
        more.set_threads(threads);
        more.find(table, lattice, x);
        CHECK(more.rest() == one.rest());
    }
}
