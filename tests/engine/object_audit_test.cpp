// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's object is const, its handles are not: the audit finds what a caller writes through them.
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <support/meshes.h>

#include <support/catch.h>

#include <type_traits>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Moving_d = std::conditional_t<d == 2, Moving_delaunay_2, Moving_delaunay_3>;
template <int d>
using Traits_d = std::conditional_t<d == 2, Cgal_traits_2<No_info>, Cgal_traits_3<No_info>>;

constexpr std::array strategies{Strategy::automatic,      Strategy::tolerances, Strategy::tolerances_each,
                                Strategy::in_place,       Strategy::rebuild,    Strategy::relocate,
                                Strategy::relocate_flips, Strategy::paper,      Strategy::paper_hybrid};

/// Calls harm(object, a finite CGAL cell), and checks that the audit reports it.
template <int d, class Harm>
void is_found(const char* words, Harm harm) {
    for (const Strategy strategy : strategies) {
        CAPTURE(name_of(strategy));
        Options options;
        options.strategy = strategy;
        const Points_d<d> x = grid<d>();
        Moving_d<d> dt(std::span<const Coordinates<d>>(x), options);
        (void)dt.move_all(std::span<const Coordinates<d>>(sheared<d>(x, 0x1p-20)));
        REQUIRE(dt.audit().first_fault == "");
        typename Traits_d<d>::Cell_handle cell;
        Traits_d<d>::for_each_cell(dt.triangulation(), [&](auto c) {
            if (!dt.triangulation().is_infinite(c)) cell = c;
        });
        harm(dt, cell);
        CHECK(!dt.audit().delaunay());
        CHECK_THAT(dt.audit().first_fault, contains(words));
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("A point that is written through a handle is found by the audit, dimension", "[audit]",
                       ((int d), d), 2, 3) {
    const auto moved = [](const auto& dt, std::size_t i, double by) {
        auto place = dt.positions()[i];
        place[0] += by;
        dt.vertex(i)->set_point(Traits_d<d>::point(place));
    };
    SECTION("far") {
        is_found<d>("the point of vertex 12 in CGAL's object is (", [&](const auto& dt, auto) { moved(dt, 12, 1.7); });
    }
    SECTION("so little that its cells are still Delaunay") {
        is_found<d>("the point of vertex 7 in CGAL's object is (",
                    [&](const auto& dt, auto) { moved(dt, 7, 0x1p-40); });
    }
    SECTION("to no number at all") {
        is_found<d>("the point of vertex 7 in CGAL's object is (nan",
                    [&](const auto& dt, auto) { moved(dt, 7, std::nan("")); });
    }
    SECTION("and put back: nothing is wrong") {
        const Points_d<d> x = grid<d>();
        const Moving_d<d> dt{std::span<const Coordinates<d>>(x)};
        moved(dt, 3, 1.0);
        CHECK(!dt.audit().delaunay());
        dt.vertex(3)->set_point(Traits_d<d>::point(x[3]));
        CHECK(dt.audit().first_fault == "");
    }
    SECTION("of a vertex in a flat set") {
        const Points_d<d> x{{}, {1}, {2}, {3}};
        const Moving_d<d> dt{std::span<const Coordinates<d>>(x)};
        CHECK(dt.audit().first_fault == "");
        moved(dt, 1, 0.5);
        CHECK_THAT(dt.audit().first_fault, contains("the point of vertex 1 in CGAL's object is (1.5"));
    }
    SECTION("of one behind an index that is free") {
        const Points_d<d> x = grid<d>();
        Moving_d<d> dt{std::span<const Coordinates<d>>(x)};
        dt.remove(dt.vertex(2));
        CHECK(dt.audit().first_fault == "");
        moved(dt, 9, 0.125);
        CHECK_THAT(dt.audit().first_fault, contains("the point of vertex 9 "));
    }
}

TEMPLATE_TEST_CASE_SIG("Cells that are written through handles are found by the audit, dimension", "[audit]",
                       ((int d), d), 2, 3) {
    SECTION("two corners exchanged") {
        is_found<d>("", [](const auto&, auto c) {
            const auto v = c->vertex(0);
            c->set_vertex(0, c->vertex(1));
            c->set_vertex(1, v);
        });
    }
    SECTION("a corner that is another vertex") {
        is_found<d>("", [](const auto& dt, auto c) {
            std::size_t i = 0;
            while (c->has_vertex(dt.vertex(i))) ++i;
            c->set_vertex(0, dt.vertex(i));
        });
    }
    SECTION("a corner that is none") {
        is_found<d>("CGAL's object has ", [](const auto&, auto c) { c->set_vertex(0, {}); });
    }
    SECTION("a neighbour that is none") {
        is_found<d>("shares no facet with it", [](const auto&, auto c) { c->set_neighbor(1, c->neighbor(0)); });
    }
    SECTION("the cell of a vertex") {
        is_found<d>("is not around it", [](const auto& dt, auto c) {
            std::size_t i = 0;
            while (c->has_vertex(dt.vertex(i))) ++i;
            Traits_d<d>::set_cell_of(dt.vertex(i), c);
        });
    }
    SECTION("the index of a vertex") {
        is_found<d>("index is not its own: 3", [](const auto& dt, auto) { dt.vertex(5)->set_index(3); });
        is_found<d>("index is not its own: 99", [](const auto& dt, auto) { dt.vertex(5)->set_index(99); });
    }
    SECTION("by CGAL, past the strategy") {
        is_found<d>("", [](const auto& dt, auto) {
            auto& tr = const_cast<typename Moving_d<d>::Triangulation&>(dt.triangulation());
            (void)tr.insert(Traits_d<d>::point(Coordinates<d>{0.25, 0.375}));
        });
        is_found<d>("CGAL's object has ", [](const auto& dt, auto) {
            auto& tr = const_cast<typename Moving_d<d>::Triangulation&>(dt.triangulation());
            tr.remove(dt.vertex(12));
        });
    }
}

TEST_CASE("Another diagonal of cocircular points, made by hand, is not the strategy's", "[audit]") {
    const Points_d<2> x{{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    Options options;
    options.strategy = Strategy::tolerances;
    const Moving_delaunay_2 dt(std::span<const Coordinates<2>>(x), options);
    auto& tr = const_cast<Moving_delaunay_2::Triangulation&>(dt.triangulation());
    const auto c = tr.finite_faces_begin();
    for (int i = 0; i < 3; ++i)
        if (!tr.is_infinite(c->neighbor(i))) {
            tr.flip(c, i);
            break;
        }
    CHECK(tr.is_valid());
    CHECK_THAT(dt.audit().first_fault, contains("the mesh has "));
}
