// SPDX-License-Identifier: GPL-3.0-or-later
// A call that runs out of memory at its n-th allocation, for every n: the object is unchanged, and the same call
// succeeds when there is memory again.
#include <common/operation.h>

#include <support/catch.h>
#include <support/failing_new.h>
#include <support/generators.h>
#include <support/repeats.h>
#include <support/viewed_mesh.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <set>
#include <sstream>
#include <thread>

using namespace annulus;
using namespace annulus::testing;

namespace {

using oracle::Setting;

template <int d>
using Moving_of = testing::Viewed_mesh<d>;

constexpr Index removed = 4;

/// Small whole numbers: cospherical, coplanar, and moves flip.
template <int d>
std::vector<Coordinates<d>> lattice(std::size_t n, std::uint64_t seed) {
    Random random(seed);
    std::set<Coordinates<d>> points;
    while (points.size() < n) {
        Coordinates<d> p;
        for (double& c : p) c = integer(random, 0, 9);
        points.insert(p);
    }
    std::vector<Coordinates<d>> x(points.begin(), points.end());
    std::shuffle(x.begin(), x.end(), random);
    return x;
}

/// A call, and its object.
template <int d>
struct Scene {
    using Moving = Moving_of<d>;

    Options options;
    std::vector<Coordinates<d>> points;
    std::unique_ptr<Moving> dt;

    explicit Scene(const Setting& setting) : points(lattice<d>(d == 2 ? 14 : 12, 5)) {
        options = {.strategy = setting.strategy, .tolerance = setting.tolerance, .report_changes = true};
        dt = std::make_unique<Moving>(points, options);
        for (auto& p : points) p[0] += 0x1p-6 * p[1];
        (void)dt->move_all(points);
        dt->remove(3);
        points[0][1] += 0.5;
        (void)dt->move(0, points[0]);
    }
};

template <int d>
struct Call {
    std::string_view name;
    std::function<void(Scene<d>&)> make;
    bool is_const = false;
};

template <int d>
std::vector<Call<d>> calls() {
    const auto moved = [](const Scene<d>& s, double by) {
        auto x = s.points;
        Random random(7);
        for (auto& p : x)
            for (double& c : p) c += by * between(random, -1, 1);
        return x;
    };
    const auto permuted = [](const Scene<d>& s) {
        auto x = s.points;
        std::rotate(x.begin() + 5, x.begin() + 6, x.end());
        return x;
    };
    const auto flat = [](const Scene<d>& s) {
        auto x = s.points;
        for (std::size_t i = 0; i < x.size(); ++i) x[i] = {static_cast<double>(i)};
        return x;
    };
    Coordinates<d> inside;
    inside.fill(4.25);
    Coordinates<d> outside;
    outside.fill(-20.5);
    return {
        {"construct", [](Scene<d>& s) { typename Scene<d>::Moving(s.points, s.options); }, true},
        {"move_all, a little", [=](Scene<d>& s) { (void)s.dt->move_all(moved(s, 0.01)); }},
        {"move_all, flips", [=](Scene<d>& s) { (void)s.dt->move_all(moved(s, 0.7)); }},
        {"move_all, far", [=](Scene<d>& s) { (void)s.dt->move_all(moved(s, 20)); }},
        {"move_all, permuted", [=](Scene<d>& s) { (void)s.dt->move_all(permuted(s)); }},
        {"move_all, on a line", [=](Scene<d>& s) { (void)s.dt->move_all(flat(s)); }},
        {"move, near", [=](Scene<d>& s) { (void)s.dt->move(1, moved(s, 0.3)[1]); }},
        {"move, through the middle", [=](Scene<d>& s) { (void)s.dt->move(1, inside); }},
        {"move, outside", [=](Scene<d>& s) { (void)s.dt->move(2, outside); }},
        {"insert", [=](Scene<d>& s) { s.dt->insert(inside); }},
        {"insert outside", [=](Scene<d>& s) { s.dt->insert(outside); }},
        {"remove", [=](Scene<d>& s) { s.dt->remove(removed); }},
        {"recompute_tolerances", [](Scene<d>& s) { (void)s.dt->recompute_tolerances(); }},
        {"tolerance", [=](Scene<d>& s) { (void)s.dt->tolerance(5); }, true},
        {"theta", [=](Scene<d>& s) { (void)s.dt->theta(5); }, true},
        {"measure", [](Scene<d>& s) { (void)s.dt->measure(); }, true},
        {"audit", [](Scene<d>& s) { (void)s.dt->audit(); }, true},
        {"audit_input", [](Scene<d>& s) { (void)s.dt->audit_input(); }, true},
    };
}

/// Empty, or the fault of an object between calls.
template <int d>
std::string fault(const Moving_of<d>& dt) {
    const Audit_result audit = dt.audit();
    if (!audit.delaunay()) return "audit: " + audit.first_fault;
    if (!dt.view_is_valid()) return "CGAL's object is not valid";
    for (Index i = 0; i < static_cast<Index>(dt.index_bound()); ++i) {
        if (!dt.is_vertex(i)) continue;
        if (dt.view_point(i) != dt.position(i)) return "CGAL's point is not the position";
        if (!(dt.tolerance(i) >= 0)) return "a tolerance is negative or NaN";
    }
    return {};
}

template <int d>
auto sorted_cells(const Moving_of<d>& dt) {
    auto cells = dt.audit_input().cells;
    for (auto& c : cells) std::sort(c.begin(), c.end());
    std::sort(cells.begin(), cells.end());
    return cells;
}

/// The state that must be unchanged even where there was not enough memory to rebuild the cells.
template <int d>
std::string identity(const Scene<d>& scene) {
    std::ostringstream said;
    said << std::hexfloat;
    const auto& dt = *scene.dt;
    for (Index i = 0; i < static_cast<Index>(dt.index_bound()); ++i) {
        if (!dt.is_vertex(i)) continue;
        said << i << ' ' << dt.handle(i) << ' ' << dt.handle_index(i);
        for (const double c : dt.points()[static_cast<std::size_t>(i)]) said << ' ' << c;
        said << '\n';
    }
    return said.str();
}

/// Makes the call with its n-th allocation failing, then further calls. Empty, or the first fault; sets `done` if it
/// made fewer allocations.
template <int d>
std::string starve_at(std::uint64_t n, const Setting& setting, const Call<d>& call, Memory memory, bool& done) {
    Scene<d> scene(setting);
    auto& dt = *scene.dt;
    const auto cells = sorted_cells<d>(dt);
    const std::string same = identity(scene);
    const Starved became = starve(n, memory, [&] { call.make(scene); });
    done = became == Starved::done;
    if (became == Starved::refused) {
        // A vertex whose removal ran out of memory may be gone, and then nothing else is missing.
        const bool gone = !dt.is_vertex(removed);
        if (gone && call.name != "remove") return "a vertex is gone";
        if (!gone && identity(scene) != same) return "positions, indices or handles changed";
        if (memory == Memory::short_for_good && !call.is_const && !dt.audit().delaunay()) {
            (void)dt.measure();
            (void)dt.tolerance(5);
            (void)dt.recompute_tolerances();
        }
        if (!gone && sorted_cells<d>(dt) != cells) return "cells changed";
        if (const std::string words = fault<d>(dt); !words.empty()) return words;
        if (!gone) call.make(scene);
    }
    if (const std::string words = fault<d>(dt); !words.empty()) return "and again: " + words;
    // State that it left behind may cause faults later.
    auto x = lattice<d>(dt.index_bound(), 11);
    (void)dt.move_all(x);
    if (const std::string words = fault<d>(dt); !words.empty()) return "and on: " + words;
    for (auto& p : x) p[0] += 0x1p-5 * p[1];
    (void)dt.move_all(x);
    if (const std::string words = fault<d>(dt); !words.empty()) return "and further on: " + words;
    return {};
}

/// One allocation of the call after another fails, each in a thread of its own: CGAL's 3D triangulation keeps a table
/// in thread-local memory, and the state after one failure must not hide the others. All of the first allocations are
/// tried, and a random share of later ones: thousands of them belong to one loop. Returns the first fault.
template <int d>
std::string starve_at_every_allocation(const Setting& setting, const Call<d>& call, Memory memory) {
    const auto share = static_cast<std::uint64_t>(repeats(d == 2 ? 40 : 10));
    Random random(run_seed());
    bool done = false;
    for (std::uint64_t n = 0; !done; n += 1 + random() % (1 + 5 * n / share)) {
        std::string words;
        std::thread([&] {
            try {
                words = starve_at(n, setting, call, memory, done);
            } catch (const std::exception& e) {
                words = std::string("threw ") + e.what();
            }
        }).join();
        if (!words.empty()) return "allocation " + std::to_string(n) + ": " + words;
    }
    return {};
}

template <int d, std::size_t N>
void starve_all(const std::array<Setting, N>& settings) {
    for (const Setting& setting : settings)
        for (const Call<d>& call : calls<d>())
            for (const Memory memory : {Memory::short_once, Memory::short_for_good}) {
                CAPTURE(d, name_of(setting.strategy), call.name, memory == Memory::short_for_good);
                CHECK(starve_at_every_allocation<d>(setting, call, memory) == "");
            }
}

}  // namespace

TEST_CASE("A call that runs out of memory leaves all as it was, whichever allocation fails", "[allocation]") {
    starve_all<2>(oracle::certified_settings);
}

TEST_CASE("A call in space that runs out of memory leaves all as it was, whichever allocation fails",
          "[allocation][space][deep]") {
    starve_all<3>(oracle::certified_settings);
}

TEST_CASE("A thread whose memory ran out once can go on triangulating space", "[allocation][space]") {
    std::string words;
    std::thread([&] {
        const auto points = lattice<3>(40, 3);
        for (std::uint64_t n = 0;; n += 1 + n / 16) {
            const Starved became = starve(n, Memory::short_once, [&] { const Moving_of<3> dt(points); });
            try {
                const Moving_of<3> dt(points);
                if (!dt.audit().delaunay()) words = "audit";
            } catch (const std::exception& e) {
                words = std::string("threw ") + e.what();
            }
            if (!words.empty()) words = "after allocation " + std::to_string(n) + " failed: " + words;
            if (became == Starved::done || !words.empty()) return;
        }
    }).join();
    CHECK(words == "");
}
