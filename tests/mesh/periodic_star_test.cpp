// SPDX-License-Identifier: GPL-3.0-or-later
// Stars of periodic tables: each corner of a vertex once, also where cells have several of them.
#include <annulus/kernel/periodic_builder.h>
#include <annulus/mesh/periodic_star.h>

#include <support/catch.h>
#include <support/periodic_boxes.h>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// Gives the cells of a table the numbers c -> size - 1 - c, and lists of corners, too.
template <int d>
std::vector<std::vector<Corner_index>> turned_around(Periodic_table<d>& table,
                                                     std::vector<std::vector<Corner_index>> corners) {
    const auto turn = [&](Corner_index& h) { h = table.corner(table.size() - 1 - table.cell_of(h), table.slot_of(h)); };
    std::reverse(table.vertex.begin(), table.vertex.end());
    std::reverse(table.offset.begin(), table.offset.end());
    std::reverse(table.twin.begin(), table.twin.end());
    for (auto& twins : table.twin) std::for_each(twins.begin(), twins.end(), turn);
    for (auto& list : corners) {
        std::for_each(list.begin(), list.end(), turn);
        std::sort(list.begin(), list.end());
    }
    return corners;
}

template <int d>
void expect_stars(const Lattice<d>& lattice, const std::vector<Coordinates<d>>& place) {
    Periodic_builder<d> builder;
    Periodic_table<d> table;
    builder.build(lattice, place, 1, table);
    std::vector<std::vector<Corner_index>> expected(place.size());
    for (std::size_t c = 0; c < table.size(); ++c)
        for (std::size_t i = 0; i <= d; ++i)
            expected[static_cast<std::size_t>(table.vertex[c][i])].push_back(table.corner(c, i));
    Periodic_star<d> star;
    star.begin(place.size());
    for (int turn = 0; turn < 3; ++turn) {
        if (turn == 1) star.forget();
        if (turn == 1) star.begin(place.size());
        if (turn == 2) expected = turned_around(table, expected);
        for (std::size_t v = 0; v < place.size(); ++v) {
            const auto found = star.of(table, static_cast<Index>(v));
            std::vector<Corner_index> sorted(found.begin(), found.end());
            std::sort(sorted.begin(), sorted.end());
            CHECK(sorted == expected[v]);
        }
    }
}

template <int d>
std::vector<Coordinates<d>> places(const Lattice<d>& lattice, const std::vector<Coordinates<d>>& points) {
    std::vector<Coordinates<d>> x;
    for (const auto& p : points) x.push_back(lattice.representative(p, 0).place);
    return x;
}

template <int d>
void expect_stars_everywhere() {
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (const std::size_t n : {1U, 2U, 3U, 12U}) {
            CAPTURE(d, kind, n);
            Periodic_cases cases(n);
            const Box<d> box = cases.box<d>(kind);
            const Lattice<d> lattice(box.vectors());
            expect_stars<d>(lattice, places<d>(lattice, cases.points<d>(box, n)));
        }
}

}  // namespace

TEST_CASE("The star of a periodic vertex has each of its corners once", "[mesh][periodic]") {
    expect_stars_everywhere<2>();
    expect_stars_everywhere<3>();
}

TEST_CASE("A star of thousands of corners is walked as others are", "[mesh][periodic]") {
    Periodic_cases cases(1);
    const Box<3> box = Box<3>::orthorhombic({1, 1, 1});
    const Lattice<3> lattice(box.vectors());
    std::vector<Coordinates<3>> x = cases.points<3>(box, 1500, 1);
    for (auto& p : x) {
        double length = 0;
        for (const double c : p) length += c * c;
        for (double& c : p) c *= 0.25 / std::sqrt(length);
    }
    x.push_back({0, 0, 0});
    expect_stars<3>(lattice, places<3>(lattice, x));
}
