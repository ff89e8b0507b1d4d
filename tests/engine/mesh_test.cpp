// SPDX-License-Identifier: GPL-3.0-or-later
// Moving_mesh beyond what every program calls (fuzz/common/mesh_twin.h): moves of some vertices, spans into itself,
// objects that are moved, so few points that a cavity is the whole mesh, neighbours. Out of memory:
// mesh_allocation_test.cpp.
#include <annulus/error.h>
#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/generators.h>
#include <support/meshes.h>

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

TEST_CASE("A few points of space whose region is everything are inserted all the same", "[mesh]") {
    // Found by an attack: the table became smaller than the cell numbers that the strategy had stored.
    for (const Strategy strategy :
         {Strategy::tolerances, Strategy::tolerances_each, Strategy::automatic, Strategy::relocate}) {
        Options options;
        options.strategy = strategy;
        const Points_d<3> x{{3, 2, 3}, {1, 0, 3}, {0, 0, 2}, {0, 3, 3}, {3, 3, 3}};
        Moving_mesh<3> mesh(std::span<const Coordinates<3>>(x), options);
        (void)mesh.move(3, {3.5, 2.5, 0.5});
        (void)mesh.move(4, {2, 0, 0});
        (void)mesh.move(2, {3.5, 1.5, 3.5});
        CHECK(mesh.audit().first_fault == "");
    }
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        Random random(seed);
        const auto place = [&random] {
            Coordinates<3> p;
            for (double& c : p) c = 0.5 * integer(random, 0, 8);
            return p;
        };
        Points_d<3> x;
        for (int i = 0; i < 6; ++i) x.push_back(place());
        Options options;
        options.strategy = seed % 2 == 0 ? Strategy::tolerances : Strategy::tolerances_each;
        options.merge_duplicates = true;
        Moving_mesh<3> mesh(std::span<const Coordinates<3>>(x), options);
        for (int move = 0; move < 12; ++move) {
            try {
                if (move % 3 == 2) (void)mesh.insert(place());
                else (void)mesh.move(static_cast<Index>(random() % mesh.index_bound()), place());
            } catch (const Error& e) {
                REQUIRE(e.code() == Error_code::duplicate_point);
            }
        }
        INFO(seed);
        REQUIRE(mesh.audit().first_fault == "");
    }
}

TEMPLATE_TEST_CASE_SIG("An insertion that is refused leaves positions, their number and what comes next, dimension",
                       "[mesh]", ((int d), d), 2, 3) {
    for (const Strategy strategy :
         {Strategy::automatic, Strategy::tolerances, Strategy::tolerances_each, Strategy::in_place, Strategy::relocate,
          Strategy::relocate_flips, Strategy::rebuild, Strategy::paper, Strategy::paper_hybrid}) {
        for (const Tolerance_kind kind : {Tolerance_kind::certified, Tolerance_kind::paper}) {
            if (kind == Tolerance_kind::paper && strategy != Strategy::paper && strategy != Strategy::paper_hybrid)
                continue;
            CAPTURE(name_of(strategy), name_of(kind));
            Options options;
            options.strategy = strategy;
            options.tolerance = kind;
            Points_d<d> x = grid<d>();
            Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), options);
            const auto refused = [&](std::size_t k) {
                try {
                    (void)mesh.insert(mesh.points()[k]);  // which moves in memory, if there is no room for one more
                    FAIL("inserted");
                } catch (const Error& e) {
                    CHECK(e.code() == Error_code::duplicate_point);
                }
                CHECK(std::equal(x.begin(), x.end(), mesh.points().begin(), mesh.points().end()));
            };
            Coordinates<d> free{};
            free.fill(0.5);
            for (int k = 0; k < 20; ++k) {
                refused(static_cast<std::size_t>(k) % x.size());
                free[0] += 0x1p-8;
                CHECK(mesh.insert(free) == static_cast<Index>(x.size()));
                x.push_back(free);
            }
            mesh.remove(3);
            x[3] = x[5];  // the position at a free index is ignored
            try {
                (void)mesh.insert(x[7]);
                FAIL("inserted");
            } catch (const Error& e) {
                CHECK(e.code() == Error_code::duplicate_point);
            }
            CHECK(mesh.index_bound() == x.size());
            CHECK(!mesh.is_vertex(3));
            free[0] += 0x1p-8;
            CHECK(mesh.insert(free) == 3);
            CHECK(mesh.points()[3] == free);
            CHECK(mesh.audit().first_fault == "");
        }
    }
}

TEMPLATE_TEST_CASE_SIG(
    "Some vertices move at once: in cycles, named twice, to the mesh's own points, or not at all, dimension", "[mesh]",
    ((int d), d), 2, 3) {
    for (const std::size_t copies : {1U, 40U}) {  // few compared with the others, and many
        Points_d<d> x;
        for (std::size_t k = 0; k < copies; ++k)
            for (auto p : grid<d>()) {
                p[1] += 9.0 * static_cast<double>(k);
                x.push_back(p);
            }
        for (const Strategy strategy :
             {Strategy::automatic, Strategy::tolerances, Strategy::tolerances_each, Strategy::rebuild}) {
            CAPTURE(copies, name_of(strategy));
            Options options;
            options.strategy = strategy;
            Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), options);
            Move_result report = mesh.move(std::vector<Index>{1, 2, 3}, Points_d<d>{x[2], x[3], x[1]});
            CHECK(report.moves.asked == 3);
            CHECK((mesh.points()[1] == x[2] && mesh.points()[2] == x[3] && mesh.points()[3] == x[1]));
            CHECK(mesh.audit().first_fault == "");
            Coordinates<d> first = x[0];
            first[0] -= 7.0;
            Coordinates<d> last = x[0];
            last[0] -= 0.25;
            report = mesh.move(std::vector<Index>{0, 0}, Points_d<d>{first, last});
            CHECK(report.moves.asked == 1);
            CHECK(mesh.points()[0] == last);
            CHECK(mesh.move(std::vector<Index>{}, Points_d<d>{}).moves.asked == 0);
            // A span into itself, over the position of a vertex that moves.
            (void)mesh.move(std::vector<Index>{5, 4}, mesh.points().subspan(4, 2));
            CHECK(mesh.audit().first_fault == "");
            // A duplicate point half way through the call: no vertex has moved.
            const Points_d<d> here(mesh.points().begin(), mesh.points().end());
            const auto cells = sorted_cells(mesh);
            Coordinates<d> free = x[6];
            free[0] += 0.3;
            CHECK_THROWS_AS(mesh.move(std::vector<Index>{6, 7}, Points_d<d>{free, here[8]}), Error);
            CHECK_THROWS_AS(mesh.move(std::vector<Index>{6}, Points_d<d>{}), Error);
            CHECK_THROWS_AS(mesh.move(std::vector<Index>{static_cast<Index>(x.size())}, Points_d<d>{free}), Error);
            CHECK(Points_d<d>(mesh.points().begin(), mesh.points().end()) == here);
            CHECK(sorted_cells(mesh) == cells);
            CHECK(mesh.audit().first_fault == "");
        }
    }
}

TEST_CASE("Meshes are built from plain numbers, and moved", "[mesh]") {
    const std::vector<double> numbers{0, 0, 4, 0, 0, 4, 3, 3, 1, 1};
    Moving_mesh_2 mesh{std::span<const double>(numbers)};
    CHECK(mesh.number_of_vertices() == 5);
    CHECK_THROWS_AS(Moving_mesh_2(std::span<const double>(numbers).first(9)), Error);
    Moving_mesh_2 other = std::move(mesh);
    (void)other.move(4, {2, 1});
    mesh = Moving_mesh_2();
    CHECK(mesh.number_of_vertices() == 0);
    CHECK(mesh.cells().vertices.empty());
    std::swap(mesh, other);
    CHECK(mesh.points()[4] == Coordinates<2>{2, 1});
    CHECK(mesh.audit().first_fault == "");
    CHECK(other.dimension() == -1);
}

TEMPLATE_TEST_CASE_SIG("The neighbours of a mesh share a facet, mutually, and what has none is on the hull, dimension",
                       "[mesh]", ((int d), d), 2, 3) {
    Random random(43);
    Points_d<d> x(70);
    for (auto& p : x)
        for (double& c : p) c = between(random, -1.0, 1.0);
    Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
    std::map<std::vector<Index>, int> facets;
    for (int step = 0; step < 3; ++step) {
        const Mesh_cells<d> cells = mesh.cells();
        facets.clear();
        const auto opposite = [&](std::size_t c, std::size_t i) {
            std::vector<Index> facet;
            for (std::size_t k = 0; k <= d; ++k)
                if (k != i) facet.push_back(cells.vertices[c][k]);
            std::sort(facet.begin(), facet.end());
            return facet;
        };
        for (std::size_t c = 0; c < cells.vertices.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i) ++facets[opposite(c, i)];
        for (std::size_t c = 0; c < cells.vertices.size(); ++c)
            for (std::size_t i = 0; i <= d; ++i) {
                const Index n = cells.neighbours[c][i];
                REQUIRE((n == cells.outside) == (facets[opposite(c, i)] == 1));
                if (n == cells.outside) continue;
                const auto& back = cells.neighbours[static_cast<std::size_t>(n)];
                const auto k =
                    static_cast<std::size_t>(std::find(back.begin(), back.end(), static_cast<Index>(c)) - back.begin());
                REQUIRE(k <= d);
                REQUIRE(opposite(static_cast<std::size_t>(n), k) == opposite(c, i));
            }
        for (auto& p : x)
            for (double& c : p) c += between(random, -0.1, 0.1);
        (void)mesh.move_all(std::span<const Coordinates<d>>(x));
    }
}
