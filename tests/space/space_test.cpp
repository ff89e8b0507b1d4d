// SPDX-License-Identifier: GPL-3.0-or-later
// Sites are compared by vertex and label; positions are subtracted coordinate by coordinate, over any type.
#include <annulus/space/places.h>

#include <support/catch.h>

#include <algorithm>
#include <string>
#include <type_traits>
#include <vector>

using namespace annulus;

namespace {

// Vertices and sites do not convert to each other; without labels a site is as large as a vertex.
static_assert(sizeof(Site<2>) == sizeof(Index) && sizeof(Site<3>) == sizeof(Index));
static_assert(!std::is_convertible_v<Index, Site<3>> && !std::is_convertible_v<Site<3>, Index>);
static_assert(std::is_constructible_v<Site<3>, Index> && std::is_trivially_copyable_v<Site<3>>);

}  // namespace

TEST_CASE("Sites are equal when vertex and label are, and ordered by both", "[space]") {
    using Image = Site_of<int>;
    CHECK((Site<2>(5) == Site<2>(5)));
    CHECK((Site<2>(5) < Site<2>(6)));
    CHECK((Site<2>(infinite) < Site<2>(0)));
    CHECK((Image(5) == Image(5, 0)));
    CHECK((Image(5, 1) != Image(5, 2)));
    std::vector<Image> images{Image(6, -1), Image(5, 2), Image(5, -2), Image(4, 7)};
    std::sort(images.begin(), images.end());
    CHECK((images == std::vector<Image>{Image(4, 7), Image(5, -2), Image(5, 2), Image(6, -1)}));
    CHECK((std::array<Site<3>, 2>{}[1] == Site<3>(0)));
}

TEST_CASE("Differences are of the second from the first, over any type", "[space]") {
    const Coordinates<3> p{5, 7, 11}, q{1, 2, 4};
    CHECK(Euclidean<3>::difference(p, q) == Coordinates<3>{4, 5, 7});
    CHECK(Euclidean<2>::difference(p, q) == Coordinates<2>{4, 5});
    const std::vector<std::string> a{"a", "b", "c"}, b{"x", "y", "z"};
    const auto written =
        Euclidean<3>::difference(a, b, [](const std::string& s, const std::string& t) { return s + t; });
    CHECK(written == std::array<std::string, 3>{"ax", "by", "cz"});
    const Tuple<3, 2> x{&p, &q};
    CHECK(difference(x, 1, 0) == Coordinates<3>{-4, -5, -7});
    CHECK(difference(x, 0, 1, [](double s, double t) { return s * t; }) == Coordinates<3>{5, 14, 44});
}

TEST_CASE("Places are read point by point", "[space]") {
    const Coordinates<3> p{5, 7, 11}, q{5, 7, 4};
    const Tuple<3, 2> x{&p, &q};
    CHECK(coordinates(x) == std::array<double, 6>{5, 7, 11, 5, 7, 4});
    CHECK(coordinate(x, 1, 2) == 4);
    CHECK(precedes(x, 1, 0));
    CHECK_FALSE(precedes(x, 0, 1));
    CHECK_FALSE(precedes(x, 0, 0));
    CHECK(seen_along(0, x) == std::array<Coordinates<2>, 2>{{{7, 11}, {7, 4}}});
    CHECK(seen_along(1, x) == std::array<Coordinates<2>, 2>{{{11, 5}, {4, 5}}});
    CHECK(seen_along(2, x) == std::array<Coordinates<2>, 2>{{{5, 7}, {5, 7}}});
}
