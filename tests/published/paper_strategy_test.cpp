// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's algorithm: Delaunay at the fixed positions even with unsound tolerances, and at the moving positions if
// tolerances are certified.

#include <annulus/moving_mesh.h>

#include <support/catch.h>
#include <support/generators.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
using Place_list = std::vector<Coordinates<d>>;

template <int d>
Place_list<d> random_points(std::size_t n, Random& random) {
    Place_list<d> x(n);
    for (auto& p : x)
        for (double& c : p) c = between(random, 0.0, 1.0);
    return x;
}

template <int d>
std::set<std::vector<Index>> cells_of(const Moving_mesh<d>& mesh) {
    std::set<std::vector<Index>> cells;
    const auto input = mesh.audit_input();
    for (const auto& cell : input.cells) {
        std::vector<Index> sorted(cell.begin(), cell.end());
        std::sort(sorted.begin(), sorted.end());
        cells.insert(sorted);
    }
    return cells;
}

/// The same cells, at the fixed positions.
template <int d>
bool delaunay_at_fixed(const Moving_mesh<d>& mesh) {
    Audit_input<d> input = mesh.audit_input();
    for (std::size_t i = 0; i < input.points.size(); ++i) input.points[i] = mesh.fixed_position(input.names[i]);
    return audit(input).delaunay();
}

template <int d>
Options paper(Tolerance_kind kind, Strategy strategy = Strategy::paper) {
    return Options{.strategy = strategy, .tolerance = kind};
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("The paper's filter keeps the mesh Delaunay at its fixed positions, dimension", "[published]",
                       ((int d), d), 2, 3) {
    for (const Tolerance_kind kind : {Tolerance_kind::certified, Tolerance_kind::paper, Tolerance_kind::floating})
        for (const double pace : {0.001, 0.01, 0.1, 1.0}) {
            CAPTURE(name_of(kind), pace);
            Random random(static_cast<std::uint64_t>(pace * 1000.0));
            Place_list<d> x = random_points<d>(60, random);
            Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), paper<d>(kind));
            Move_counts counts;
            for (int step = 0; step < 12; ++step) {
                for (auto& p : x)
                    for (double& c : p) c += pace * between(random, -0.5, 0.5);
                counts += mesh.move_all(x).moves;
                CHECK(delaunay_at_fixed(mesh));
                if (kind != Tolerance_kind::certified) continue;
                CHECK(mesh.audit().delaunay());
                const Moving_mesh<d> fresh{std::span<const Coordinates<d>>(x)};
                CHECK(cells_of(mesh) == cells_of(fresh));
            }
            CHECK(counts.asked == 12 * 60);
            if (pace == 0.001) CHECK(counts.within_tolerance > 0);
            if (pace == 0.01) CHECK(counts.kept_in_place > 0);
            if (pace == 0.1 && d == 2) CHECK(counts.flipped > 0);
            if (pace == 1.0) CHECK(counts.reinserted > 0);
        }
}

TEST_CASE("A vertex that meets another on the way of the paper's queue is refused, and nothing has changed",
          "[published]") {
    // 3 moves to where 2 has moved within its tolerance: this is detected only when 3 is there.
    const Place_list<2> home{{2, 0}, {1, 1}, {0, 1}, {2, 2}};
    Moving_mesh<2> mesh(std::span<const Coordinates<2>>(home), paper<2>(Tolerance_kind::certified));
    const Coordinates<2> near{0.0093125, 0.979563};
    CHECK(mesh.move(2, near).moves.within_tolerance == 1);
    CHECK_THROWS_AS(mesh.move(3, near), Error);
    CHECK(mesh.points()[3] == home[3]);
    CHECK(mesh.audit().delaunay());
    CHECK(delaunay_at_fixed(mesh));
    for (Index v = 0; v < 4; ++v) CHECK(mesh.displacement(v) <= mesh.tolerance(v));
    CHECK_THROWS_AS(mesh.move_all(Place_list<2>{home[0], home[1], near, near}), Error);
    CHECK(mesh.points()[2] == near);
    CHECK(mesh.audit().delaunay());
    CHECK_NOTHROW(mesh.move(3, {0.5, 3.0}));
    CHECK(mesh.audit().delaunay());
}

TEMPLATE_TEST_CASE_SIG("A refused insertion leaves the paper's fixed positions and tolerances, dimension",
                       "[published]", ((int d), d), 2, 3) {
    Random random(5);
    Place_list<d> x = random_points<d>(30, random);
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x), paper<d>(Tolerance_kind::certified));
    for (auto& p : x) p[0] += 1e-6;
    (void)mesh.move_all(x);
    const std::vector<double> before = mesh.tolerances();
    const Coordinates<d> fixed = mesh.fixed_position(0);
    CHECK_THROWS_AS(mesh.insert(x[7]), Error);
    CHECK(mesh.tolerances() == before);
    CHECK(mesh.fixed_position(0) == fixed);
    Coordinates<d> free{};
    free.fill(0.5);
    const Index i = mesh.insert(free);
    CHECK(mesh.fixed_position(0) == x[0]);
    CHECK(mesh.audit().delaunay());
    mesh.remove(i);
    CHECK(mesh.audit().delaunay());
}

TEMPLATE_TEST_CASE_SIG("The paper's hybrid rebuilds, and filters once the motion is slow, dimension", "[published]",
                       ((int d), d), 2, 3) {
    Random random(9);
    Place_list<d> x = random_points<d>(80, random);
    Moving_mesh<d> mesh(std::span<const Coordinates<d>>(x),
                        paper<d>(Tolerance_kind::certified, Strategy::paper_hybrid));
    const auto step = [&](double pace) {
        for (auto& p : x)
            for (double& c : p) c += pace * between(random, -0.5, 0.5);
        return mesh.move_all(x).moves;
    };
    for (int k = 0; k < 8; ++k) CHECK(step(0.5).rebuilt == 80);
    CHECK(mesh.strategy() == Strategy::paper_hybrid);
    for (int k = 0; k < 8; ++k) (void)step(1e-7);
    CHECK(mesh.strategy() == Strategy::paper);
    CHECK(step(1e-7).rebuilt == 0);
    CHECK(mesh.audit().delaunay());
}
