// SPDX-License-Identifier: GPL-3.0-or-later
// Periodic_mesh::insert and remove: the cells of a fresh build after every call, audited; indices; errors.
#include <annulus/error.h>
#include <annulus/kernel/periodic_builder.h>
#include <annulus/kernel/periodic_inserter.h>
#include <annulus/periodic_mesh.h>

#include <support/catch.h>
#include <support/cells_of_periodic.h>
#include <support/failing_new.h>
#include <support/periodic_boxes.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Everything that can be seen, but for the numbers of cells.
template <int d>
void expect_equal_meshes(const Periodic_mesh<d>& mesh, const Periodic_mesh<d>& fresh) {
    CHECK(cells_of(mesh) == cells_of(fresh));
    CHECK(mesh.number_of_cells() == fresh.number_of_cells());
    const auto a = mesh.neighbours(), b = fresh.neighbours();
    CHECK((a.first == b.first && a.second == b.second && a.shift == b.shift && a.vector == b.vector));
    REQUIRE(a.area.size() == b.area.size());
    for (std::size_t k = 0; k < a.area.size(); ++k) CHECK((a.area[k] == 0) == (b.area[k] == 0));  // cospherical
}

/// Compares the mesh with a build of the same points, and audits it.
template <int d>
void expect_fresh(const Periodic_mesh<d>& mesh) {
    expect_equal_meshes(mesh, Periodic_mesh<d>(mesh.saved()));
    const Audit_result audit = mesh.audit();
    CHECK(audit.first_fault.empty());
    CHECK(audit.delaunay());
    const auto volumes = mesh.voronoi_volumes();
    REQUIRE(volumes.size() == mesh.index_bound());
    double sum = 0;
    for (std::size_t i = 0; i < volumes.size(); ++i) {
        const bool there = mesh.is_vertex(static_cast<Index>(i));
        CHECK(std::isnan(volumes[i]) == !there);
        CHECK(std::isnan(mesh.points()[i][0]) == !there);
        if (there) sum += volumes[i];
    }
    if (mesh.number_of_vertices() > 0) CHECK(sum == Approx(mesh.box().volume()).epsilon(1e-9));
}

/// From no point to `most` and back, one point at a time, in another order.
template <int d>
void expect_up_and_down(int kind, std::size_t most, std::uint64_t seed) {
    CAPTURE(d, kind, most, seed);
    Periodic_cases cases(seed);
    const Box<d> box = cases.box<d>(kind);
    Periodic_mesh<d> mesh({}, box);
    expect_fresh(mesh);
    for (std::size_t k = 0; k < most; ++k) {
        CHECK(mesh.insert(cases.point<d>(box, 3)) == static_cast<Index>(k));
        CHECK(mesh.number_of_vertices() == k + 1);
        expect_fresh(mesh);
    }
    std::vector<Index> left(most);
    for (std::size_t k = 0; k < most; ++k) left[k] = static_cast<Index>(k);
    while (!left.empty()) {
        std::swap(left[cases.below(left.size())], left.back());
        mesh.remove(left.back());
        CHECK(!mesh.is_vertex(left.back()));
        left.pop_back();
        CHECK(mesh.number_of_vertices() == left.size());
        expect_fresh(mesh);
    }
    CHECK(mesh.number_of_cells() == 0);
    CHECK(mesh.index_bound() == most);
}

/// Insertions, removals, several at once, and moves, in any order.
template <int d>
void expect_right_mixture(int kind, std::uint64_t seed) {
    CAPTURE(d, kind, seed);
    Periodic_cases cases(seed);
    const Box<d> box = cases.box<d>(kind);
    Periodic_mesh<d> mesh(cases.points<d>(box, 12), box);
    for (int step = 0; step < 12; ++step) {
        const std::size_t bound = mesh.index_bound();
        std::vector<Index> some;
        for (std::size_t i = 0; i < bound; ++i)
            if (mesh.is_vertex(static_cast<Index>(i)) && cases.below(step % 2 == 0 ? 15 : 3) == 0)
                some.push_back(static_cast<Index>(i));
        if (step % 3 == 0) mesh.remove(some);
        if (step % 3 == 1) {
            const std::size_t vertices = mesh.number_of_vertices();
            const auto indices = mesh.insert(cases.points<d>(box, cases.below(step % 2 == 0 ? 3 : 20)));
            CHECK(mesh.number_of_vertices() == vertices + indices.size());
            for (const Index i : indices) CHECK(mesh.is_vertex(i));
        }
        if (step % 3 == 2) {
            std::vector<Coordinates<d>> x(mesh.points().begin(), mesh.points().end());
            for (auto& p : x)
                for (double& c : p) c += cases.uniform(-0.02, 0.02);
            const Move_result result = mesh.move_all(x, box);
            CHECK(result.moves.asked == mesh.number_of_vertices());
        }
        expect_fresh(mesh);
    }
}

/// The lattice of a conventional cell with these points, so many times along each axis, all coordinates exact.
template <int d>
std::vector<Coordinates<d>> crystal(const std::vector<Coordinates<d>>& cell, int times) {
    std::vector<Coordinates<d>> points;
    for (int k = 0; k < (d == 2 ? times * times : times * times * times); ++k)
        for (Coordinates<d> p : cell) {
            int left = k;
            for (std::size_t i = 0; i < d; ++i, left /= times) p[i] += left % times;
            points.push_back(p);
        }
    return points;
}

/// Every atom is taken out and put back, as it was and beside; a vacancy and an interstitial each time.
template <int d>
void expect_defects(const std::vector<Coordinates<d>>& cell, int times) {
    CAPTURE(d, cell.size(), times);
    const auto points = crystal<d>(cell, times);
    Coordinates<d> lengths;
    lengths.fill(times);
    Periodic_mesh<d> mesh(points, Box<d>::orthorhombic(lengths));
    const auto before = cells_of(mesh);
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 9) {
        mesh.remove(static_cast<Index>(i));
        expect_fresh(mesh);
        Coordinates<d> image = points[i];
        image[0] += times;
        image[1] -= 2 * times;
        CHECK(mesh.insert(points[i]) == static_cast<Index>(i));
        CHECK(cells_of(mesh) == before);
        mesh.remove(static_cast<Index>(i));
        CHECK(mesh.insert(image) == static_cast<Index>(i));
        expect_fresh(mesh);
        mesh.remove(static_cast<Index>(i));
        Coordinates<d> beside = points[i];
        for (double& c : beside) c += 0.25;
        CHECK(mesh.insert(beside) == static_cast<Index>(i));
        const Index more = mesh.insert(points[i]);
        expect_fresh(mesh);
        mesh.remove(static_cast<Index>(i));
        mesh.remove(more);
        CHECK(mesh.insert(points[i]) == more);
        CHECK(mesh.number_of_cells() == before.size());
        mesh.remove(more);
        mesh = Periodic_mesh<d>(points, Box<d>::orthorhombic(lengths));
    }
}

template <class Call>
Error refusal_of(Call call) {
    try {
        call();
    } catch (const Error& e) {
        return e;
    }
    FAIL("no error");
    return {Error_code::usage, ""};
}

template <int d>
void expect_refusals(std::size_t n) {
    CAPTURE(d, n);
    Periodic_cases cases(n);
    const Box<d> box = cases.box<d>(4);
    auto x = cases.points<d>(box, n);
    for (auto& p : x) p = coarse(p);
    Periodic_mesh<d> mesh(x, box);
    const auto removed = static_cast<Index>(n / 2);
    if (n > 1) mesh.remove(removed);
    const auto cells = cells_of(mesh);
    const auto expect_unchanged = [&] {
        CHECK(cells_of(mesh) == cells);
        CHECK(mesh.index_bound() == n);
        CHECK(mesh.number_of_vertices() == (n > 1 ? n - 1 : n));
        CHECK(mesh.saved().free_indices.size() == n - mesh.number_of_vertices());
    };
    const auto expect_refused = [&](Error_code code, std::vector<std::int64_t> vertices, auto call) {
        const Error e = refusal_of(call);
        CHECK(e.code() == code);
        CHECK(std::vector<std::int64_t>(e.vertices().begin(), e.vertices().end()) == vertices);
        expect_unchanged();
    };
    const auto fresh = cases.points<d>(box, 40);
    // At a vertex: itself and other images of it.
    for (const std::size_t v : {std::size_t{0}, n - 1}) {
        if (n > 1 && v == n / 2) continue;
        for (const std::int32_t times : {0, 1, -3}) {
            Coordinates<d> p = mesh.places()[v];
            for (std::size_t i = 0; i < d; ++i) p[i] += times * box.vectors()[d - 1][i];
            const auto named = static_cast<std::int64_t>(v);
            expect_refused(Error_code::duplicate_point, {named}, [&] { mesh.insert(p); });
            expect_refused(Error_code::duplicate_point, {named}, [&] { mesh.insert(std::vector{fresh[0], p}); });
            auto many = fresh;
            many[7] = p;
            expect_refused(Error_code::duplicate_point, {named}, [&] { mesh.insert(many); });
        }
    }
    // Two of one call.
    for (const std::size_t count : {std::size_t{2}, fresh.size()}) {
        std::vector<Coordinates<d>> twice(fresh.begin(), fresh.begin() + static_cast<std::ptrdiff_t>(count));
        twice[count - 1] = twice[0] = Coordinates<d>{0.125, 0.25};
        for (std::size_t i = 0; i < d; ++i) twice[0][i] += box.vectors()[0][i];
        expect_refused(Error_code::duplicate_point, {}, [&] { mesh.insert(twice); });
        const std::string what = refusal_of([&] { mesh.insert(twice); }).what();
        CHECK(what.find("points 0 and " + std::to_string(count - 1)) != std::string::npos);
    }
    for (const double wrong : {nan, std::numeric_limits<double>::infinity()}) {
        auto many = fresh;
        many[5][1] = wrong;
        expect_refused(Error_code::not_finite, {0}, [&] { mesh.insert(many[5]); });
        expect_refused(Error_code::not_finite, {5}, [&] { mesh.insert(many); });
    }
    Coordinates<d> far{};
    far[0] = 1e300;
    expect_refused(Error_code::out_of_domain, {0}, [&] { mesh.insert(far); });
    for (const Index i : {Index{-1}, static_cast<Index>(n), std::numeric_limits<Index>::max()})
        expect_refused(Error_code::unknown_vertex, {i}, [&] { mesh.remove(i); });
    if (n > 1) {
        expect_refused(Error_code::unknown_vertex, {removed}, [&] { mesh.remove(removed); });
        expect_refused(Error_code::unknown_vertex, {removed}, [&] {
            mesh.remove(std::vector<Index>{static_cast<Index>(n - 1), removed});
        });
    }
    expect_refused(Error_code::unknown_vertex, {static_cast<std::int64_t>(n - 1)}, [&] {
        mesh.remove(std::vector<Index>{static_cast<Index>(n - 1), static_cast<Index>(n - 1)});
    });
    mesh.insert(std::span<const Coordinates<d>>());
    mesh.remove(std::span<const Index>());
    expect_unchanged();
    const auto at_free = std::vector<Coordinates<d>>(n, Coordinates<d>{nan, nan});
    if (n > 2) CHECK(refusal_of([&] { mesh.move_all(at_free); }).code() == Error_code::not_finite);
    CHECK(refusal_of([&] { mesh.move_all(fresh); }).code() == Error_code::wrong_size);
    expect_unchanged();
}

/// How many of so many insertions, and of as many removals, changed cells near the point only.
template <int d>
std::array<std::size_t, 2> local_changes(const Box<d>& box, Periodic_cases& cases, std::size_t n, std::size_t count) {
    const Lattice<d> lattice(box.vectors());
    std::vector<Coordinates<d>> place;
    for (const auto& p : cases.points<d>(box, n)) place.push_back(lattice.representative(p, 0).place);
    Periodic_table<d> table;
    Periodic_builder<d>().build(lattice, place, 1, table);
    Periodic_inserter<d> inserter;
    std::array<std::size_t, 2> local{};
    for (std::size_t k = 0; k < count; ++k) {
        place.push_back(lattice.representative(cases.point<d>(box, 1), 0).place);
        const auto inserted = inserter.insert({table, lattice, place}, static_cast<Index>(place.size() - 1));
        if (inserted.outcome == Periodic_insertion::Outcome::done) ++local[0];
        else Periodic_builder<d>().build(lattice, place, 1, table);
    }
    for (std::size_t k = 0; k < count; ++k) {
        const bool done = inserter.remove({table, lattice, place}, static_cast<Index>(place.size() - 1));
        place.pop_back();
        if (done) ++local[1];
        else Periodic_builder<d>().build(lattice, place, 1, table);
    }
    return local;
}

}  // namespace

TEST_CASE("A periodic mesh grows from no point and shrinks to none, in every box", "[kernel][periodic]") {
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind) {
        expect_up_and_down<2>(kind, 14, 1);
        expect_up_and_down<3>(kind, 10, 2);
    }
    for (int k = 0; k < repeats(1); ++k) {
        expect_up_and_down<2>(0, 60, static_cast<std::uint64_t>(k));
        expect_up_and_down<3>(4, 40, static_cast<std::uint64_t>(k));
    }
}

TEST_CASE("Insertions, removals and moves of a periodic mesh are right in any order", "[kernel][periodic]") {
    for (int kind = 0; kind < Periodic_cases::kinds; ++kind)
        for (int k = 0; k < repeats(2); ++k) {
            expect_right_mixture<2>(kind, static_cast<std::uint64_t>(k));
            expect_right_mixture<3>(kind, static_cast<std::uint64_t>(k));
        }
}

TEST_CASE("Vacancies and interstitials of crystals", "[kernel][periodic]") {
    expect_defects<2>({{0, 0}}, 4);
    expect_defects<2>({{0, 0}, {0.5, 0.5}}, 3);
    expect_defects<3>({{0, 0, 0}}, 3);
    expect_defects<3>({{0, 0, 0}, {0.5, 0.5, 0.5}}, 2);
    expect_defects<3>({{0, 0, 0}, {0.5, 0.5, 0}, {0.5, 0, 0.5}, {0, 0.5, 0.5}}, 2);
}

TEST_CASE("What cannot be inserted or removed changes nothing", "[kernel][periodic]") {
    for (const std::size_t n : {1U, 2U, 30U}) {
        expect_refusals<2>(n);
        expect_refusals<3>(n);
    }
}

TEST_CASE("Indices of a periodic mesh: the one freed last is taken first, and saved meshes keep them",
          "[kernel][periodic]") {
    Periodic_cases cases(3);
    const Box<2> box = cases.box<2>(0);
    Periodic_mesh<2> mesh(cases.points<2>(box, 20), box);
    mesh.remove(std::vector<Index>{3, 17, 5});
    mesh.remove(8);
    CHECK((mesh.number_of_vertices() == 16 && mesh.index_bound() == 20));
    CHECK((mesh.saved().free_indices == std::vector<Index>{3, 17, 5, 8}));
    CHECK((mesh.neighbour_counts()[5] == 0 && mesh.neighbour_counts()[4] > 0));
    CHECK((mesh.images()[3] == Shift<2>{} && std::isnan(mesh.places()[3][0])));
    Periodic_mesh<2> again(mesh.saved());
    expect_equal_meshes(again, mesh);
    for (Periodic_mesh<2>* m : {&mesh, &again}) {
        CHECK(m->insert({0.1, 0.2}) == 8);
        CHECK((m->insert(std::vector<Coordinates<2>>{{0.3, 0.2}, {0.4, 0.2}, {0.5, 0.7}, {0.6, 0.7}}) ==
               std::vector<Index>{5, 17, 3, 20}));
        expect_fresh(*m);
    }
    auto saved = mesh.saved();
    for (const auto& wrong : {std::vector<Index>{-1}, std::vector<Index>{21}, std::vector<Index>{2, 2}}) {
        saved.free_indices = wrong;
        CHECK(refusal_of([&] { Periodic_mesh<2> m(saved); }).code() == Error_code::bad_input);
    }
    saved.free_indices = {0, 4};  // what is there is not read
    const Periodic_mesh<2> fewer(saved);
    CHECK((fewer.number_of_vertices() == 19 && !fewer.is_vertex(4)));
    mesh.remove(std::vector<Index>{4, 0});
    CHECK(cells_of(mesh) == cells_of(fewer));
    // Positions of the mesh are arguments as good as others.
    const Coordinates<2>& first = mesh.points()[1];
    CHECK(refusal_of([&] { mesh.insert(first); }).vertices()[0] == 1);
}

TEST_CASE("An insertion or a removal in a box that runs out of memory changes nothing", "[kernel][periodic]") {
    Periodic_cases cases(8);
    for (const std::size_t n : {3U, 60U}) {  // built, and near the point
        const Box<2> box = cases.box<2>(4);
        Periodic_mesh<2> mesh(cases.points<2>(box, n), box);
        mesh.remove(0);
        const auto more = cases.points<2>(box, 3);
        const auto expect_unchanged_when_starved = [&](auto call) {
            const auto before = cells_of(mesh);
            const std::size_t bound = mesh.index_bound(), vertices = mesh.number_of_vertices();
            for (std::uint64_t k = 0;; ++k) {
                const Starved outcome = starve(k, Memory::short_for_good, call);
                if (outcome == Starved::done) break;
                CHECK(outcome == Starved::refused);
                REQUIRE(cells_of(mesh) == before);
                REQUIRE((mesh.index_bound() == bound && mesh.number_of_vertices() == vertices));
            }
            CHECK(mesh.number_of_vertices() != vertices);
            expect_fresh(mesh);
        };
        std::vector<Index> indices;
        expect_unchanged_when_starved([&] { mesh.insert(more[0]); });
        expect_unchanged_when_starved([&] { indices = mesh.insert(std::span(more).subspan(1)); });
        expect_unchanged_when_starved([&] { mesh.remove(1); });
        expect_unchanged_when_starved([&] { mesh.remove(indices); });
    }
}

TEST_CASE("Insertion and removal in a box change cells near the point only", "[kernel][periodic]") {
    Periodic_cases cases(5);
    // Cavities of different images touch.
    CHECK(local_changes<2>(cases.box<2>(0), cases, 5, 40) == std::array<std::size_t, 2>{40, 40});
    CHECK(local_changes<3>(cases.box<3>(0), cases, 8, 40) == std::array<std::size_t, 2>{40, 40});
    for (const int kind : {0, 4, 7}) {
        CAPTURE(kind);
        CHECK(local_changes<2>(cases.box<2>(kind), cases, 100, 40) == std::array<std::size_t, 2>{40, 40});
        CHECK(local_changes<3>(cases.box<3>(kind), cases, 200, 40) == std::array<std::size_t, 2>{40, 40});
    }
}
