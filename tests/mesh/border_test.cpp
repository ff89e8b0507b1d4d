// SPDX-License-Identifier: GPL-3.0-or-later
// The connectedness of infinity: one simplex, and two that share nothing but infinity, each of whose borders winds
// once.
#include <annulus/mesh/border.h>

#include <support/catch.h>

#include <array>
#include <vector>

using namespace annulus;

namespace {

/// A simplex of vertices first, first + 1, ... and the cells with infinity around it.
template <int d>
void add_simplex(Corner_table<d>& t, Index first) {
    const Cell_index inside = t.new_cell();
    for (int i = 0; i <= d; ++i) t.set_site(t.corner(inside, i), Site<d>(first + i));
    std::array<Cell_index, static_cast<std::size_t>(d + 1)> outside;
    for (int i = 0; i <= d; ++i) {
        // Infinity in the place of vertex i. Which way round it goes does not matter here.
        const Cell_index c = outside[static_cast<std::size_t>(i)] = t.new_cell();
        for (int k = 0; k <= d; ++k) t.set_site(t.corner(c, k), Site<d>(k == i ? infinite : first + k));
        t.set_adjacency(t.corner(inside, i), t.corner(c, i));
    }
    for (int i = 0; i <= d; ++i)
        for (int k = 0; k < i; ++k)
            t.set_adjacency(t.corner(outside[static_cast<std::size_t>(i)], k),
                            t.corner(outside[static_cast<std::size_t>(k)], i));
}

}  // namespace

TEST_CASE("In space two borders that share nothing but infinity are not one", "[border]") {
    Corner_table<3> t;
    t.clear(8);
    add_simplex<3>(t, 0);
    CHECK(border_is_whole(t));
    add_simplex<3>(t, 4);
    CHECK_FALSE(border_is_whole(t));
}

TEST_CASE("In the plane two borders that share nothing but infinity are not one", "[border]") {
    // The corners of a cell go around it counter-clockwise there, so the cell with infinity has two of them exchanged.
    const auto add_triangle = [](Corner_table<2>& t, Index first) {
        const Cell_index inside = t.new_cell();
        for (int i = 0; i < 3; ++i) t.set_site(t.corner(inside, i), Site<2>(first + i));
        std::array<Cell_index, 3> outside;
        for (int i = 0; i < 3; ++i) {
            const Cell_index c = outside[static_cast<std::size_t>(i)] = t.new_cell();
            t.set_site(t.corner(c, 0), Site<2>(infinite));
            t.set_site(t.corner(c, 1), Site<2>(first + (i + 2) % 3));
            t.set_site(t.corner(c, 2), Site<2>(first + (i + 1) % 3));
            t.set_adjacency(t.corner(inside, i), t.corner(c, 0));
        }
        for (int i = 0; i < 3; ++i)  // across the edge from infinity to vertex i + 1
            t.set_adjacency(t.corner(outside[static_cast<std::size_t>(i)], 1),
                            t.corner(outside[static_cast<std::size_t>((i + 2) % 3)], 2));
    };
    Corner_table<2> t;
    t.clear(6);
    add_triangle(t, 0);
    CHECK(border_is_whole(t));
    add_triangle(t, 3);
    CHECK_FALSE(border_is_whole(t));
}
