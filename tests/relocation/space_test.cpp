// SPDX-License-Identifier: GPL-3.0-or-later
// Moving_delaunay_3: whole programs of calls on point sets of every family. After each call the audit, the mirror and a rebuild
// must agree.
#include <support/session_3.h>

#include <support/arbitrary.h>

#include <catch2/catch.hpp>

#include <cmath>
#include <numeric>

using namespace annulus;
using namespace annulus::testing;
using Kind = Operation_3::Kind;

namespace {

constexpr std::array strategies{Strategy::rebuild, Strategy::relocate,    Strategy::relocate_flips, Strategy::in_place,
                                Strategy::filter,  Strategy::filter_each, Strategy::hybrid};

/// Moves between the places of a pool that is used again and again, so that vertices return and meet.
Program_3 program_of(Strategy strategy, Set_3 set, std::uint64_t seed, int most, int calls) {
    Random random(seed);
    const auto number = [&](std::size_t bound) { return static_cast<std::size_t>(random() % bound); };
    const auto n = static_cast<std::size_t>(integer(random, 0, most));
    const Points_3 pool = point_set(set, n + n / 2 + 3, random);
    Program_3 program{strategy, {pool.begin(), pool.begin() + static_cast<std::ptrdiff_t>(n)}, {}};
    std::size_t bound = n;
    const auto place = [&] { return pool[number(pool.size())]; };
    const auto near = [&](Coordinates<3> p) {
        const Coordinates<3> other = place();
        const int share = -static_cast<int>(number(50));
        for (std::size_t k = 0; k < 3; ++k) p[k] += std::ldexp(other[k] - p[k], share);
        return p;
    };
    const auto all = [&](bool shuffled) {
        Points_3 x = pool;
        if (shuffled)
            for (std::size_t i = x.size(); i > 1; --i) std::swap(x[i - 1], x[number(i)]);
        if (x.size() < bound) x = point_set(set, bound, random);
        x.resize(bound);
        return x;
    };
    for (int call = 0; call < calls; ++call) {
        auto& out = program.operations;
        switch (number(12)) {
            case 0:
            case 1: out.push_back({Kind::move, static_cast<Index>(number(bound + 1)), {place()}}); break;
            case 2:
            case 3: {
                const std::size_t v = number(bound + 1);
                out.push_back({Kind::move, static_cast<Index>(v), {near(v < n ? pool[v] : place())}});
                break;
            }
            case 4:
            case 5: out.push_back({Kind::move_all, none, all(true)}); break;
            case 6:
            case 7:
            case 8: {  // all go home, some a little off
                Points_3 x = all(false);
                for (auto& p : x)
                    if (number(3) == 0) p = near(p);
                out.push_back({Kind::move_all, none, x});
                break;
            }
            case 9:
                out.push_back({Kind::insert, none, {place()}});
                ++bound;
                break;
            case 10: out.push_back({Kind::remove, static_cast<Index>(number(bound + 1)), {}}); break;
            default: out.push_back({}); break;
        }
    }
    return program;
}

/// Programs with an insertion that was refused would call move_all with too many points: cut to the size the model has.
std::string run_fitted(Program_3& program) {
    std::size_t bound = program.points.size();
    std::vector<Index> vacant;
    std::vector<std::optional<Coordinates<3>>> sites(program.points.begin(), program.points.end());
    for (auto& o : program.operations) {
        const auto meets = [&](const Coordinates<3>& p, Index but) {
            for (std::size_t i = 0; i < sites.size(); ++i)
                if (sites[i] && static_cast<Index>(i) != but && *sites[i] == p) return true;
            return false;
        };
        const bool live = o.vertex >= 0 && static_cast<std::size_t>(o.vertex) < sites.size() &&
                          sites[static_cast<std::size_t>(o.vertex)];
        if (o.kind == Kind::move_all) {
            while (o.points.size() < bound) o.points.push_back({1e3 + static_cast<double>(o.points.size()), 5, 7});
            o.points.resize(bound);
            Points_3 after;
            for (std::size_t i = 0; i < bound; ++i)
                if (sites[i]) after.push_back(o.points[i]);
            std::sort(after.begin(), after.end());
            if (std::adjacent_find(after.begin(), after.end()) != after.end()) continue;
            for (std::size_t i = 0; i < bound; ++i)
                if (sites[i]) sites[i] = o.points[i];
        } else if (o.kind == Kind::insert && !meets(o.points[0], none)) {
            if (vacant.empty()) {
                sites.emplace_back(o.points[0]);
                ++bound;
            } else {
                sites[static_cast<std::size_t>(vacant.back())] = o.points[0];
                vacant.pop_back();
            }
        } else if (o.kind == Kind::remove && live) {
            sites[static_cast<std::size_t>(o.vertex)].reset();
            vacant.push_back(o.vertex);
        } else if (o.kind == Kind::move && live && !meets(o.points[0], o.vertex)) {
            sites[static_cast<std::size_t>(o.vertex)] = o.points[0];
        }
    }
    return run(program);
}

void survives(Strategy strategy, int most, int calls) {
    REQUIRE(rc::check([=] {
        const Set_3 set = all_sets_3[*rc::gen::inRange<std::size_t>(0, all_sets_3.size())];
        Program_3 program = program_of(strategy, set, *seeds(), most, calls);
        const std::string fault = run_fitted(program);
        if (!fault.empty()) RC_FAIL(fault + "\n" + as_code(program));
    }));
}

Points_3 grid(int side) {
    Points_3 points;
    for (int i = 0; i < side; ++i)
        for (int j = 0; j < side; ++j)
            for (int k = 0; k < side; ++k)
                points.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
    return points;
}

/// Moves and returns many times, by any share of the spacing; checks now and then.
void wanders_and_returns(Strategy strategy, const Points_3& home, int steps, int check_every) {
    Session_3 session(strategy, home);
    Random random(7);
    for (int step = 0; step < steps; ++step) {
        Points_3 away = home;
        for (auto& p : away)
            for (double& c : p)
                if (random() % 2 == 0) c += std::ldexp(between(random, -0.4, 0.4), -step % 50);
        session.apply({Kind::move_all, none, away});
        if (step % check_every == 0) session.check();
        session.apply({Kind::move_all, none, home});
        if (step % check_every == 0) session.check();
    }
    session.check();
    session.apply({});
    session.check();
}

}  // namespace

TEST_CASE("After any calls in space under any strategy the audit passes and the cells are those of a rebuild",
          "[relocation][space]") {
    for (const Strategy strategy : strategies) {
        DYNAMIC_SECTION(name_of(strategy)) {
            survives(strategy, 9, 16);
            survives(strategy, 40, 8);
        }
    }
}

TEST_CASE("A lattice, a prism and a sphere that move and return many times are still Delaunay", "[relocation][space]") {
    Points_3 prism;
    for (int floor = 0; floor < 5; ++floor)
        for (int k = 0; k < 4; ++k)
            prism.push_back({k % 2 == 0 ? 3.0 : -3.0, k / 2 == 0 ? 4.0 : -4.0, static_cast<double>(floor)});
    Random random(3);
    const Points_3 sphere = point_set(Set_3::sphere, 60, random);
    for (const Strategy strategy : {Strategy::in_place, Strategy::filter, Strategy::filter_each, Strategy::relocate}) {
        CAPTURE(name_of(strategy));
        for (const auto& [home, steps] : {std::pair{grid(3), 20}, {prism, 20}, {sphere, 20}}) {
            try {
                wanders_and_returns(strategy, home, steps, 7);
            } catch (const Session_3::Fault& fault) {
                FAIL(fault.words);
            }
        }
    }
}

TEST_CASE("After a refused call in space the flips that it took back do no harm", "[relocation][space]") {
    for (const Strategy strategy : {Strategy::filter, Strategy::filter_each}) {
        CAPTURE(name_of(strategy));
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            CAPTURE(seed);
            Random random(seed);
            const Set_3 set = std::array{Set_3::sphere, Set_3::uniform, Set_3::near_sphere}[seed % 3];
            const Points_3 home = point_set(set, 12, random);
            try {
                Session_3 session(strategy, home);
                for (int call = 0; call < 6; ++call) {
                    const auto v = static_cast<Index>(random() % 12);
                    const std::size_t w = (static_cast<std::size_t>(v) + 1 + random() % 11) % 12;
                    session.apply({Kind::move, v, {home[w]}});  // w is there
                    session.check();
                    Points_3 x = home;
                    for (double& c : x[random() % 12]) c *= 0.125 * integer(random, 1, 7);
                    session.apply({Kind::move_all, none, x});
                    session.check();
                    session.apply({Kind::move_all, none, home});
                    session.check();
                }
            } catch (const Session_3::Fault& fault) {
                FAIL(fault.words);
            }
        }
    }
}
