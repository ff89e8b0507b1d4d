// SPDX-License-Identifier: GPL-3.0-or-later
// Moving_delaunay made from pairs, from triangulations of CGAL's and by copying, over a caller's own vertices and
// cells.
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <CGAL/Delaunay_triangulation_cell_base_3.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <support/cases.h>
#include <support/cgal_triangulations.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

// Bases of a caller's own, with names that Indexed_vertex_base_2 and _3 have, too, and data at cells.
template <class Gt, class Vb>
struct Own_vertex : Vb {
    template <class Tds>
    struct Rebind_TDS {
        using Other = Own_vertex<Gt, typename Vb::template Rebind_TDS<Tds>::Other>;
    };
    using Vb::Vb;
    std::string index = "none";
    std::vector<int> more;
};
/// CGAL's bases with info leave an int uninitialised.
struct Mark {
    int value = 0;
};
using Own_2 = CGAL::Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<Own_vertex<Kernel, CGAL::Triangulation_vertex_base_2<Kernel>>,
                                                 CGAL::Triangulation_face_base_with_info_2<Mark, Kernel>>>;
using Own_3 = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<Own_vertex<Kernel, CGAL::Triangulation_vertex_base_3<Kernel>>,
                                                 CGAL::Triangulation_cell_base_with_info_3<
                                                     Mark, Kernel, CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>>;
using With_info_2 = CGAL::Delaunay_triangulation_2<
    Kernel, CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<std::string, Kernel>>>;
using With_info_3 = CGAL::Delaunay_triangulation_3<
    Kernel, CGAL::Triangulation_data_structure_3<CGAL::Triangulation_vertex_base_with_info_3<std::string, Kernel>,
                                                 CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;
using Plain_2 = CGAL::Delaunay_triangulation_2<Kernel>;
using Plain_3 = CGAL::Delaunay_triangulation_3<Kernel>;

template <int d>
using Own = std::conditional_t<d == 2, Own_2, Own_3>;
template <int d>
using Plain = std::conditional_t<d == 2, Plain_2, Plain_3>;
template <int d>
using With_info = std::conditional_t<d == 2, With_info_2, With_info_3>;
template <int d>
using Ours =
    std::conditional_t<d == 2, Moving_delaunay_with_info_2<std::string>, Moving_delaunay_with_info_3<std::string>>;

template <int d, class Dt>
void move_about(Moving_delaunay<Dt>& dt, Random& random) {
    for (const double pace : {1e-6, 0.01, 0.5}) {
        Points_of<d> x(dt.positions().begin(), dt.positions().end());
        for (auto& p : x)
            for (double& c : p) c += pace * between(random, -1.0, 1.0);
        (void)dt.move_all(x);
        REQUIRE(dt.audit().delaunay());
        REQUIRE(dt.triangulation().is_valid());
    }
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("From pairs of a point and its info, dimension", "[cgal]", ((int d), d), 2, 3) {
    auto x = places<d>(20, 1);
    x.push_back(x[3]);
    std::vector<std::pair<typename Ours<d>::Point, std::string>> pairs;
    for (std::size_t i = 0; i < x.size(); ++i) pairs.emplace_back(point<d>(x[i]), "info " + std::to_string(i));
    CHECK_THROWS_AS(Ours<d>(pairs.begin(), pairs.end()), Error);
    const Ours<d> dt(pairs.begin(), pairs.end(), {.merge_duplicates = true});
    REQUIRE(dt.number_of_vertices() == 20);
    for (std::size_t i = 0; i < 20; ++i) {
        CHECK(dt.vertex(i)->info() == "info " + std::to_string(i));  // of two at one position the first
        CHECK(dt.vertex(i)->point() == point<d>(x[i]));
    }
    CHECK(dt.audit().delaunay());
}

TEMPLATE_TEST_CASE_SIG("From a triangulation of the same type, with all data of its vertices, dimension", "[cgal]",
                       ((int d), d), 2, 3) {
    Random random(2);
    Own<d> theirs;
    for (const auto& p : places<d>(60, 2)) theirs.insert(point<d>(p));
    std::map<typename Own<d>::Point, std::string> name;
    for (auto v = theirs.finite_vertices_begin(); v != theirs.finite_vertices_end(); ++v) {
        v->index = "vertex " + std::to_string(name.size());
        v->more = {static_cast<int>(name.size())};
        name[v->point()] = v->index;
    }
    Moving_delaunay<Own<d>> dt(theirs);
    static_assert(std::is_same_v<decltype(dt.triangulation()), const Own<d>&>);
    REQUIRE(dt.number_of_vertices() == 60);
    CHECK(cells_of(dt.triangulation()) == cells_of(theirs));
    std::size_t i = 0;
    for (auto v = theirs.finite_vertices_begin(); v != theirs.finite_vertices_end(); ++v, ++i) {
        const auto ours = dt.vertex(i);
        CHECK((ours->point() == v->point() && ours->index == v->index && ours->more == v->more));
        CHECK(dt.index(ours) == static_cast<Index>(i));
        CHECK_THROWS_AS(dt.index(v), Error);  // a vertex of the other triangulation
    }
    CHECK_THROWS_AS(dt.index(dt.triangulation().infinite_vertex()), Error);
    // Data live as long as their vertex.
    const auto seventh = dt.vertex(7);
    move_about<d>(dt, random);
    CHECK((dt.vertex(7) == seventh && seventh->index == "vertex 7"));
    dt.remove(seventh);
    const auto fresh = dt.insert(point<d>(places<d>(1, 9)[0]));
    CHECK((dt.index(fresh) == 7 && fresh->index == "none"));
    CHECK_THROWS_AS(dt.insert(fresh->point()), Error);
    move_about<d>(dt, random);
    // The other one has not changed.
    CHECK(theirs.number_of_vertices() == 60);
    for (auto v = theirs.finite_vertices_begin(); v != theirs.finite_vertices_end(); ++v)
        CHECK(name.at(v->point()) == v->index);
}

TEMPLATE_TEST_CASE_SIG("From a triangulation of another type, with info where both have it, dimension", "[cgal]",
                       ((int d), d), 2, 3) {
    Random random(3);
    With_info<d> theirs;
    for (const auto& p : places<d>(40, 3)) theirs.insert(point<d>(p))->info() = std::to_string(p[0]);
    Ours<d> dt(theirs, {.strategy = Strategy::tolerances});
    CHECK(cells_of(dt.triangulation()) == cells_of(theirs));
    for (std::size_t i = 0; i < 40; ++i) CHECK(dt.vertex(i)->info() == std::to_string(dt.positions()[i][0]));
    Moving_delaunay<Plain<d>> without(theirs);
    move_about<d>(without, random);
    CHECK(Moving_delaunay<Plain<d>>(Plain<d>()).number_of_vertices() == 0);
}

TEMPLATE_TEST_CASE_SIG("Points on a line and single points, with vertices of the caller's, dimension", "[cgal]",
                       ((int d), d), 2, 3) {
    Moving_delaunay<Own<d>> dt;
    Coordinates<d> p{};
    for (int k = 0; k < 5; ++k, p[0] += 1) {
        (void)dt.insert(point<d>(p));
        CHECK(dt.triangulation().is_valid());
        CHECK(dt.triangulation().dimension() == std::min(k, 1));
        CHECK(dt.audit().delaunay());
    }
    for (int k = 1; k < d; ++k) {
        p[static_cast<std::size_t>(k)] = 1;
        (void)dt.insert(point<d>(p));
    }
    CHECK(dt.triangulation().dimension() == d);
    CHECK(dt.audit().delaunay());
    CHECK(dt.triangulation().is_valid());
}

TEMPLATE_TEST_CASE_SIG("Data at cells that a call has written have their defaults, dimension", "[cgal]", ((int d), d),
                       2, 3) {
    Moving_delaunay<Own<d>> dt(std::span<const Coordinates<d>>(places<d>(60, 4)),
                               {.strategy = Strategy::tolerances, .report_changes = true});
    const auto all = [&](auto visit) {
        const Own<d>& t = dt.triangulation();
        if constexpr (d == 2)
            for (auto f = t.all_faces_begin(); f != t.all_faces_end(); ++f) visit(*f);
        else
            for (auto c = t.all_cells_begin(); c != t.all_cells_end(); ++c) visit(*c);
    };
    std::size_t cells = 0;
    all([&](auto& c) { c.info().value = 1, ++cells; });
    auto x = Points_of<d>(dt.positions().begin(), dt.positions().end());
    x[5][0] += 0.1;
    const Move_result r = dt.move_all(x);
    std::size_t kept = 0, now = 0;
    all([&](auto& c) { kept += c.info().value == 1 ? 1U : 0U, ++now; });
    CAPTURE(kept, now, r.moves.rebuilt, r.moves.reinserted, r.moves.flipped, r.statistics.flips, r.changed.size());
    CHECK((kept > 0 && kept < now));
    CHECK(now - kept >= r.changed.size() / (d + 1));
}

TEMPLATE_TEST_CASE_SIG("A copy lives by itself, dimension", "[cgal]", ((int d), d), 2, 3) {
    Random random(5);
    for (const Strategy strategy : {Strategy::automatic, Strategy::rebuild, Strategy::in_place, Strategy::tolerances,
                                    Strategy::paper, Strategy::paper_hybrid}) {
        CAPTURE(name_of(strategy));
        const auto x = places<d>(50, 6);
        auto dt = std::make_unique<Ours<d>>(std::span<const Coordinates<d>>(x), Options{.strategy = strategy});
        for (std::size_t i = 0; i < 50; ++i) dt->vertex(i)->info() = std::to_string(i);
        move_about<d>(*dt, random);
        dt->remove(dt->vertex(11));
        dt->remove(dt->vertex(30));
        const Points_of<d> before(dt->positions().begin(), dt->positions().end());
        const auto same = [&](const auto& l, const auto& r) {
            for (std::size_t i = 0; i < l.size(); ++i)
                if (i != 11 && i != 30 && l[i] != r[i]) return false;
            return l.size() == r.size();
        };
        Ours<d> copy(*dt);
        Ours<d> assigned;
        assigned = copy;
        for (const Ours<d>* const c : {&copy, &assigned}) {
            CHECK(same(c->positions(), before));
            CHECK(cells_of(c->triangulation()) == cells_of(dt->triangulation()));
            CHECK(c->options().strategy == strategy);
            CHECK((c->vertex(11) == nullptr && c->vertex(3) != dt->vertex(3) && c->vertex(3)->info() == "3"));
            CHECK(std::ranges::equal(c->vertex_of_input(), dt->vertex_of_input()));
            CHECK_THROWS_AS(c->index(dt->vertex(3)), Error);
        }
        // What happens to one does not happen to the other.
        copy.vertex(3)->info() = "of the copy";
        move_about<d>(copy, random);
        CHECK(dt->vertex(3)->info() == "3");
        CHECK(same(dt->positions(), before));
        CHECK(dt->audit().delaunay());
        const Points_of<d> far(copy.positions().begin(), copy.positions().end());
        move_about<d>(*dt, random);
        dt.reset();
        CHECK(same(copy.positions(), far));
        CHECK(copy.audit().delaunay());
        CHECK(copy.index(copy.insert(point<d>(places<d>(1, 7)[0]))) == 30);  // the index freed last
        CHECK(copy.index(copy.insert(point<d>(places<d>(1, 8)[0]))) == 11);
        move_about<d>(copy, random);
        CHECK(same(assigned.positions(), before));
        move_about<d>(assigned, random);
        // Of a mesh without an object of CGAL, too.
        Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), {.strategy = strategy});
        mesh.remove(4);
        Moving_mesh<d> twin(mesh);
        (void)mesh.move(5, places<d>(1, 9)[0]);
        CHECK((twin.points()[5] == x[5] && !twin.is_vertex(4) && twin.audit().delaunay()));
        CHECK(twin.insert(x[4]) == 4);
        CHECK((twin.audit().delaunay() && !mesh.is_vertex(4)));
        mesh = twin;
        CHECK((mesh.is_vertex(4) && mesh.points()[5] == x[5] && mesh.audit().delaunay()));
    }
}
