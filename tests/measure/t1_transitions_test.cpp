// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/t1_transitions.h>

#include <support/catch.h>

#include <vector>

using namespace annulus;

namespace {

using Cells = std::vector<Index>;

T1_transitions found(const Cells& came, const Cells& gone) { return t1_transitions(came, gone); }

}  // namespace

TEST_CASE("A T1 transition is two triangles at an edge that became two at the other diagonal", "[t1]") {
    REQUIRE(found({2, 3, 0, 3, 2, 1}, {0, 1, 2, 1, 0, 3}) == T1_transitions{{0, 1, 2, 3}});
    REQUIRE(found({1, 5, 9, 1, 9, 7}, {7, 5, 9, 7, 1, 5}) == T1_transitions{{5, 7, 1, 9}});
    REQUIRE(found({}, {}).empty());
    // Two of them, ascending.
    REQUIRE(found({12, 13, 10, 13, 12, 11, 2, 3, 0, 3, 2, 1}, {10, 11, 12, 11, 10, 13, 0, 1, 2, 1, 0, 3}) ==
            T1_transitions{{0, 1, 2, 3}, {10, 11, 12, 13}});
}

TEST_CASE("Pairs that are made and broken otherwise are no T1 transitions", "[t1]") {
    REQUIRE(found({2, 3, 0, 3, 2, 1, 0, 1, 4}, {0, 1, 2, 1, 0, 3}).empty());  // 0 and 1 are neighbours elsewhere
    REQUIRE(found({2, 3, 0, 3, 2, 1}, {0, 1, 2, 1, 0, 3, 2, 3, 4}).empty());  // 2 and 3 were neighbours elsewhere
    REQUIRE(found({2, 3, 0, 3, 2, 4}, {0, 1, 2, 1, 0, 3}).empty());           // 1 is not beside them
    REQUIRE(found({2, 3, 0}, {0, 1, 2, 1, 0, 3}).empty());                    // at the hull
    REQUIRE(found({0, 2, -1}, {0, 1, 2, 1, 0, -1}).empty());                  // through the hull
    REQUIRE(found({0, 2, -2, 2, 1, -2}, {0, 1, -2, 1, 2, -2}).empty());       // on a line
    REQUIRE(found({0, 2, 4, 2, 3, 4, 3, 0, 4}, {0, 1, 2, 1, 0, 3}).empty());  // two flips in one place
}

TEST_CASE("T1 transitions are those of several changes as a whole", "[t1]") {
    const Cells one{2, 3, 0, 3, 2, 1}, other{0, 1, 2, 1, 0, 3};
    Cells came(one), gone(other);
    const auto then = [&](const Cells& next, const Cells& before) {
        came.insert(came.end(), next.begin(), next.end());
        gone.insert(gone.end(), before.begin(), before.end());
    };
    then(other, one);
    REQUIRE(found(came, gone).empty());  // there and back
    then(one, other);
    REQUIRE(found(came, gone) == T1_transitions{{0, 1, 2, 3}});
    then({2, 3, 9}, {2, 3, 9});  // a triangle for a moment
    REQUIRE(found(came, gone) == T1_transitions{{0, 1, 2, 3}});
    then({2, 3, 6, 3, 0, 6, 0, 2, 6}, {2, 3, 0});  // a vertex in one of the new triangles
    REQUIRE(found(came, gone).empty());
}
