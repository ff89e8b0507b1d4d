// SPDX-License-Identifier: GPL-3.0-or-later
// Moving_delaunay::move_if_no_collision beside the function of CGAL's that has this name.
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <support/cases.h>
#include <support/cgal_triangulations.h>

#include <algorithm>
#include <type_traits>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEMPLATE_TEST_CASE_SIG("move_if_no_collision does what CGAL's does, dimension", "[cgal]", ((int d), d), 2, 3) {
    using Theirs =
        std::conditional_t<d == 2, CGAL::Delaunay_triangulation_2<Kernel>, CGAL::Delaunay_triangulation_3<Kernel>>;
    Random random(8);
    const auto x = places<d>(30, 10);
    Theirs theirs;
    std::vector<typename Theirs::Vertex_handle> handle;
    for (const auto& p : x) handle.push_back(theirs.insert(point<d>(p)));
    Moving_delaunay<Theirs> dt(std::span<const Coordinates<d>>(x), Options{});
    int collisions = 0;
    for (int k = 0; k < 300; ++k) {
        const std::size_t i = random() % 30, j = random() % 30;
        auto to = random() % 3 == 0 ? handle[j]->point() : point<d>(places<d>(1, random())[0]);
        const auto ours = dt.move_if_no_collision(dt.vertex(i), to);
        const auto cgal = theirs.move_if_no_collision(handle[i], to);
        const bool collides = cgal != handle[i];
        collisions += collides ? 1 : 0;
        const auto expected =
            collides ? static_cast<std::size_t>(std::find(handle.begin(), handle.end(), cgal) - handle.begin()) : i;
        REQUIRE(dt.index(ours) == static_cast<Index>(expected));
        REQUIRE(dt.vertex(i)->point() == handle[i]->point());
    }
    CHECK(collisions > 20);
    CHECK(cells_of(dt.triangulation()) == cells_of(theirs));
    CHECK(dt.audit().delaunay());
    auto nowhere = x[0];
    nowhere[0] = 1e200;
    CHECK_THROWS_AS(dt.move_if_no_collision(dt.vertex(1), point<d>(nowhere)), Error);
    CHECK_THROWS_AS(dt.move_if_no_collision({}, point<d>(x[0])), Error);
}
