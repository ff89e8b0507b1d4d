// SPDX-License-Identifier: GPL-3.0-or-later
// CGAL's triangulation is a copy of the mesh that is updated on request.
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>

#include <support/catch.h>
#include <support/repeats.h>
#include <support/small_sets.h>

#include <algorithm>
#include <map>
#include <thread>
#include <type_traits>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

struct Label {
    int number = -1;
};

template <int d>
using Labelled = std::conditional_t<d == 2, Moving_delaunay_with_info_2<Label>, Moving_delaunay_with_info_3<Label>>;

template <int d>
Coordinates<d> somewhere(Random& random, double extent) {
    Coordinates<d> p;
    for (double& c : p) c = extent * between(random, 0, 1);
    return p;
}

template <int d>
auto cgal_point(const Coordinates<d>& p) {
    return std::apply([](auto... c) { return typename Labelled<d>::Point(c...); }, p);
}

/// Checks that the object is the mesh, corner by corner (audit), and a valid triangulation for CGAL.
template <int d>
void check_view(const Labelled<d>& dt) {
    const Audit_result verdict = dt.audit();
    INFO(verdict.first_fault);
    REQUIRE(verdict.delaunay());
    const auto& tr = dt.triangulation();
    REQUIRE(tr.tds().is_valid());
    REQUIRE(tr.number_of_vertices() == dt.number_of_vertices());
    REQUIRE(tr.dimension() == dt.mesh().dimension());
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("CGAL's triangulation is the mesh, however much has changed since the last call, dimension",
                       "[view]", ((int d), d), 2, 3) {
    Random random(run_seed());
    for (int round = 0; round < repeats(20); ++round) {
        Options options;
        options.strategy = round % 3 == 0   ? Strategy::tolerances
                           : round % 3 == 1 ? Strategy::automatic
                                            : Strategy::relocate;
        Labelled<d> dt(options);
        std::map<int, typename Labelled<d>::Vertex_handle> handle;  // by label, which stays with the vertex
        int labels = 0;
        for (int change = 0; change < 60; ++change) {
            CAPTURE(round, change);
            for (std::size_t kind = random() % 6, some = 1 + random() % 8; some > 0; --some) {
                const double extent = random() % 4 == 0 ? 1.0 : 8.0;
                if (handle.empty() || kind < 2) {
                    const auto v = dt.insert(cgal_point<d>(somewhere<d>(random, extent)));
                    REQUIRE(v->info().number == -1);  // not that of a vertex that was removed
                    v->info().number = labels;
                    handle[labels++] = v;
                    continue;
                }
                const auto some_vertex =
                    std::next(handle.begin(), static_cast<std::ptrdiff_t>(random() % handle.size()));
                if (kind == 2) {
                    dt.remove(some_vertex->second);
                    handle.erase(some_vertex);
                } else if (kind == 3) {
                    (void)dt.move(some_vertex->second, cgal_point<d>(somewhere<d>(random, extent)));
                } else {
                    std::vector<Coordinates<d>> x(dt.positions().begin(), dt.positions().end());
                    for (auto& p : x) {
                        const auto step = somewhere<d>(random, kind == 4 ? 0.01 : 4.0);
                        for (std::size_t k = 0; k < d; ++k) p[k] += step[k];
                    }
                    (void)dt.move_all(std::span<const Coordinates<d>>(x));
                }
            }
            if (random() % 3 != 0) continue;
            check_view<d>(dt);
            for (const auto& [label, v] : handle) {
                REQUIRE(v->info().number == label);
                REQUIRE(dt.vertex(static_cast<std::size_t>(dt.index(v))) == v);
                REQUIRE(v->point() == dt.position(v));
            }
        }
    }
}

TEMPLATE_TEST_CASE_SIG("CGAL's triangulation follows points into a hyperplane and out of it, dimension", "[view]",
                       ((int d), d), 2, 3) {
    Random random(run_seed());
    std::vector<Coordinates<d>> full(30);
    for (auto& p : full) p = somewhere<d>(random, 1);
    Labelled<d> dt{std::span<const Coordinates<d>>(full)};
    for (int flat = 0; flat < d; ++flat)
        for (int round = 0; round < 2; ++round) {
            std::vector<Coordinates<d>> x = full;
            for (auto& p : x) std::fill(p.begin() + std::max(flat, 1), p.end(), 0.5);
            (void)dt.move_all(std::span<const Coordinates<d>>(x));
            check_view<d>(dt);
            CHECK(dt.triangulation().dimension() == std::max(flat, 1));
            (void)dt.move_all(std::span<const Coordinates<d>>(full));
            if (round == 0) check_view<d>(dt);
        }
}

TEST_CASE("Several threads that request CGAL's triangulation at once all get the present one", "[view][threads]") {
    Random random(run_seed());
    std::vector<Coordinates<3>> x(400);
    for (auto& p : x) p = somewhere<3>(random, 1);
    Moving_delaunay_3 dt{std::span<const Coordinates<3>>(x)};
    for (int step = 0; step < 8; ++step) {
        for (auto& p : x) p[0] += 0.02 * between(random, -1, 1);
        (void)dt.move_all(std::span<const Coordinates<3>>(x));
        std::vector<std::size_t> cells(4);
        std::vector<std::thread> askers;
        for (std::size_t k = 0; k < cells.size(); ++k)
            askers.emplace_back([&dt, &cells, k] { cells[k] = dt.triangulation().number_of_finite_cells(); });
        for (std::thread& t : askers) t.join();
        for (const std::size_t n : cells) CHECK(n == dt.cells().vertices.size());
    }
    CHECK(dt.audit().delaunay());
}
