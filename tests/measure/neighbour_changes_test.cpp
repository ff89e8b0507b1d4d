// SPDX-License-Identifier: GPL-3.0-or-later
// Changes of neighbours, compared with the edges of triangulations that are rebuilt.
#include <annulus/measure/neighbour_changes.h>
#include <annulus/moving_mesh.h>
#include <support/catch.h>
#include <support/repeats.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <random>
#include <set>

using namespace annulus;

namespace {

using Id = std::uint64_t;
using Pairs = std::set<std::pair<Id, Id>>;

/// The edges of the Delaunay triangulation of these points, built from nothing.
template <int d>
Pairs pairs_of(const std::map<Id, Coordinates<d>>& points) {
    std::vector<Id> id;
    std::vector<Coordinates<d>> x;
    for (const auto& [i, p] : points) {
        id.push_back(i);
        x.push_back(p);
    }
    Pairs pairs;
    const Moving_mesh<d> fresh{std::span<const Coordinates<d>>(x)};
    for (const auto& cell : fresh.cells().vertices)
        for (const Index a : cell)
            for (const Index b : cell)
                if (a >= 0 && b >= 0 && id[static_cast<std::size_t>(a)] < id[static_cast<std::size_t>(b)])
                    pairs.emplace(id[static_cast<std::size_t>(a)], id[static_cast<std::size_t>(b)]);
    return pairs;
}

/// A mesh in which points come, go and move, and their ids.
template <int d>
struct Crowd {
    std::mt19937_64& random;
    Moving_mesh<d> mesh;
    Neighbour_changes<d> changes;
    std::map<Id, Coordinates<d>> points;
    std::map<Id, Index> index;
    std::size_t free = static_cast<std::size_t>(
        d);  // coordinates that are not 0: where one less, all points are in a plane or on a line
    Id next = 100;

    Coordinates<d> somewhere() {
        Coordinates<d> p{};
        for (std::size_t k = 0; k < free; ++k) p[k] = std::uniform_real_distribution<double>()(random);
        return p;
    }
    void push(Coordinates<d>& p, double pace) {
        for (std::size_t k = 0; k < free; ++k) p[k] += std::normal_distribution<double>(0, pace)(random);
    }
    void note(const Move_result& report) { changes.note(report.changed, report.gone); }
    void come() {
        const Coordinates<d> p = somewhere();
        Move_result report;
        const Index i = mesh.insert(p, &report);
        index[next] = i;
        points[next] = p;
        changes.name(i, next++);
        note(report);
    }
    void go() {
        const auto it = std::next(points.begin(), static_cast<std::ptrdiff_t>(random() % points.size()));
        Move_result report;
        mesh.remove(index.at(it->first), &report);
        note(report);
        index.erase(it->first);
        points.erase(it);
    }
    void shake(double pace) {
        std::vector<Coordinates<d>> x(mesh.index_bound());
        for (auto& [id, p] : points) {
            push(p, pace);
            x[static_cast<std::size_t>(index.at(id))] = p;
        }
        note(mesh.move_all(x));
    }
    void shift(double pace) {
        auto& [id, p] = *std::next(points.begin(), static_cast<std::ptrdiff_t>(random() % points.size()));
        push(p, pace);
        note(mesh.move(index.at(id), p));
    }
};

}  // namespace

TEMPLATE_TEST_CASE_SIG("Pairs made and broken are those of fresh triangulations", "[measure]", ((int d), d), 2, 3) {
    for (const Strategy strategy :
         {Strategy::automatic, Strategy::tolerances, Strategy::tolerances_each, Strategy::paper_hybrid,
          Strategy::rebuild, Strategy::relocate, Strategy::relocate_flips, Strategy::in_place}) {
        for (int run = 0; run < repeats(4); ++run) {
            std::mt19937_64 random(1000 * static_cast<unsigned>(run) + static_cast<unsigned>(strategy));
            INFO("strategy " << name_of(strategy) << ", run " << run);
            Crowd<d> crowd{random, Moving_mesh<d>({.strategy = strategy, .report_changes = true}), {}, {}, {}};
            if (run % 2 == 1) crowd.free = static_cast<std::size_t>(d) - 1;
            Pairs before;
            std::uint64_t changed = 0;
            for (int frame = 0; frame < 30; ++frame) {
                // From no points to many, and back to a few: flat sets, too.
                for (std::size_t k = random() % 5; k > 0; --k) crowd.come();
                if (frame > 20)
                    for (std::size_t k = random() % 6; k > 0 && crowd.points.size() > 1; --k) crowd.go();
                if (crowd.points.empty()) continue;
                const double pace = std::ldexp(1.0, -static_cast<int>(random() % 10));
                if (random() % 3 > 0) crowd.shake(pace);
                else crowd.shift(pace);
                const Pairs after = pairs_of<d>(crowd.points);
                Pairs made, broken;
                std::set_difference(after.begin(), after.end(), before.begin(), before.end(),
                                    std::inserter(made, made.end()));
                std::set_difference(before.begin(), before.end(), after.begin(), after.end(),
                                    std::inserter(broken, broken.end()));
                Pairs said_made, said_broken;
                for (const Neighbour_change& c : crowd.changes.take()) {
                    CHECK(c.first < c.second);
                    CHECK((c.made ? said_made : said_broken).emplace(c.first, c.second).second);
                    ++changed;
                }
                CHECK(said_made == made);
                CHECK(said_broken == broken);
                before = after;
            }
            CHECK(changed > 30);
        }
    }
}

TEST_CASE("In the plane a flip breaks one pair and makes one", "[measure]") {
    const std::vector<Coordinates<2>> square{{0, 0}, {1, 0}, {1, 1.1}, {0, 1}, {-5, -5}, {5, -5}, {5, 5}, {-5, 5}};
    Moving_mesh<2> mesh(std::span<const Coordinates<2>>(square),
                        {.strategy = Strategy::tolerances, .report_changes = true});
    Neighbour_changes<2> changes;
    for (Index i = 0; i < 8; ++i) changes.name(i, 10 + static_cast<Id>(i));
    const Move_result report = mesh.move(2, {1, 0.9});
    changes.note(report.changed, report.gone);
    const std::vector<Neighbour_change> said = changes.take();
    CHECK(std::count(said.begin(), said.end(), Neighbour_change{10, 12, true}) == 1);
    CHECK(std::count(said.begin(), said.end(), Neighbour_change{11, 13, false}) == 1);
    for (const bool made : {true, false})
        CHECK(static_cast<std::uint64_t>(std::count_if(
                  said.begin(), said.end(), [=](const auto& c) { return c.made == made; })) == report.statistics.flips);
    CHECK(changes.take().empty());
    // A pair made and broken between two calls of take() is not reported.
    for (const Coordinates<2>& p : {Coordinates<2>{1, 1.1}, Coordinates<2>{1, 0.9}}) {
        const Move_result back = mesh.move(2, p);
        changes.note(back.changed, back.gone);
    }
    CHECK(changes.take().empty());
}
