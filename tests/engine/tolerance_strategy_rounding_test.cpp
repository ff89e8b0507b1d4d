// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers that the strategies store are rounded in the safe direction, to the last bit: path lengths up, expiries and
// tolerances down. Moves cannot show this, because an expiry is cut to 21 bits, which hides the last ones. So these
// tests write numbers into the state of a strategy for which rounding to nearest goes the wrong way, and compare with
// rational numbers.

#include <engine/strategy_session.h>

#include <support/catch.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <cmath>
#include <span>
#include <utility>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

REVEAL(Budget_member, &Tolerance_strategy<2>::displacement_budget_);
REVEAL(Examination, &Tolerance_strategy<2>::repair_);
REVEAL(List, &Displacement_budget<2>::list_);
REVEAL(Expiries, &Displacement_budget<2>::expiries_);
REVEAL(Path_length, &Displacement_budget<2>::path_length);
REVEAL(Set_threshold, &Displacement_budget<2>::set_threshold);
REVEAL(Rebase, &Displacement_budget<2>::rebase);

struct Strategy_session : Session<Tolerance_strategy<2>> {
    explicit Strategy_session(Random& random) : Session(random, Strategy::tolerances) {}
    [[nodiscard]] Displacement_budget<2>& displacement_budget() { return Session::operator[](Budget_member{}); }
    template <class Name>
    auto& operator[](Name) {
        return displacement_budget().*member(Name{});
    }
    template <class Name, class... Arguments>
    auto call(Name, Arguments&&... arguments) {
        return (displacement_budget().*member(Name{}))(std::forward<Arguments>(arguments)...);
    }
    [[nodiscard]] Certificate_checker<2>& examination() { return Session::operator[](Examination{}).checker(); }
};

/// The expiries of facet f, point by point.
std::vector<Expiry*> expiries(Strategy_session& s, Corner_index f) {
    std::vector<Expiry*> out;
    for (std::size_t k = 0; k < 4; ++k) out.push_back(&s[Expiries{}].of_facet(f, s.mesh.table().twin(f), k));
    return out;
}

double odd(Random& random, int exponent) { return std::ldexp(1.0 + unit(random), exponent); }

}  // namespace

TEST_CASE("A path length is at least base and displacement", "[relocation][rounding]") {
    REQUIRE(for_all("of every magnitude", [](const Seed& seed) {
        Random random = seed.random();
        Strategy_session s(random);
        for (int i = 0; i < 200; ++i) {
            const Index v = integer(random, 0, static_cast<int>(s.points.size()) - 1);
            const Point f = s.strategy.fixed_position(v);
            const double way = std::ldexp(1.0, -integer(random, 0, 80));
            const Point x{f[0] + way * between(random, -1, 1), f[1] + way * between(random, -1, 1)};
            s[List{}][at(v)].base = random() % 4 == 0 ? 0.0 : odd(random, integer(random, -40, 3));
            const Rational left = Rational(s.call(Path_length{}, v, x)) - Rational(s[List{}][at(v)].base);
            RC_ASSERT(left >= 0);
            RC_ASSERT(left * left >= exact_squared_distance(x, f));
        }
    }));
}

TEST_CASE("What a vertex may move, and what passes, is below earliest expiry less base", "[relocation][rounding]") {
    REQUIRE(for_all("where the difference rounds up", [](const Seed& seed) {
        Random random = seed.random();
        Strategy_session s(random);
        for (int i = 0; i < 200; ++i) {
            const Index v = integer(random, 0, static_cast<int>(s.points.size()) - 1);
            auto& list = s[List{}][at(v)];
            list.base = odd(random, -integer(random, 0, 70));
            list.clear();
            const double span = std::ldexp(1.0 + unit(random), -integer(random, 0, 40));
            list.put_new(0, Expiry::lower(random() % 8 == 0 ? list.base : list.base + span));
            const Rational room = Rational(list.earliest().path_length()) - Rational(list.base);
            const double tolerance = s.displacement_budget().slack(v);
            RC_ASSERT(Rational(tolerance) <= room || tolerance <= 0.0);
            s.call(Set_threshold{}, v);
            // Exactly as far as the budget allows, and so little that the square is 0.
            const Point f = s.strategy.fixed_position(v);
            const double reach = room > 0 ? rounded_down(room) : 0x1p-600;
            const double angle = between(random, 0.0, 6.3);
            for (const Point& p : {Point{f[0] + reach * std::cos(angle), f[1] + reach * std::sin(angle)},
                                   Point{f[0] + reach, f[1]}, Point{f[0] + 0x1p-600, f[1]}}) {
                if (p == f || !s.displacement_budget().passes(v, p)) continue;
                RC_ASSERT(room > 0);
                RC_ASSERT(exact_squared_distance(p, f) < room * room);
            }
        }
    }));
}

TEST_CASE("An expiry is not above base plus tolerance", "[relocation][rounding]") {
    REQUIRE(for_all("where their sum is just below a number of 21 bits", [](const Seed& seed) {
        Random random = seed.random();
        Strategy_session s(random);
        const auto cells = s.finite_cells();
        s.strategy.refresh(cells, s.report);
        std::vector<double> tolerances;
        for (const auto& e : s.examination().facets())
            if (e.kind != Facet_kind::nothing) tolerances.push_back(e.value.tolerance);
        for (int i = 0; i < 20; ++i) {
            for (auto& list : s[List{}]) {
                const double tolerance = tolerances[random() % tolerances.size()];
                const double sum = 1.0 + std::ldexp(integer(random, 1, 9), -20);
                if (tolerance < 0.5) list.base = rounded_down(Rational(sum) - Rational(tolerance));
            }
            s.strategy.refresh(cells, s.report);
            const auto check = [&](Index v, Expiry e, double tolerance) {
                RC_ASSERT(Rational(e.path_length()) <= Rational(s[List{}][at(v)].base) + Rational(tolerance));
            };
            for (const auto& e : s.examination().facets()) {
                if (e.kind == Facet_kind::nothing) continue;
                for (const auto& [v, label] : e.point)
                    if (v != none)
                        check(v, std::as_const(s[Expiries{}]).of_facet(s.mesh.table(), e.id, v), e.value.tolerance);
            }
            for (const auto& e : s.examination().cells()) {
                if (e.kind == Facet_kind::nothing) continue;
                for (std::size_t k = 0; k < e.point.size(); ++k)
                    check(e.point[k].vertex, s[Expiries{}].of_cell(Corner_table<2>::corner(e.id, static_cast<int>(k))),
                          e.value.tolerance);
            }
        }
    }));
}

TEST_CASE("Rebasing leaves no certificate more than it had", "[relocation][rounding]") {
    REQUIRE(for_all("where the rest is just below a number of 21 bits", [](const Seed& seed) {
        Random random = seed.random();
        Strategy_session s(random);
        for (int i = 0; i < 50; ++i) {
            const Index v = integer(random, 0, static_cast<int>(s.points.size()) - 1);
            const double base = random() % 2 == 0 ? odd(random, -integer(random, 55, 70)) : unit(random);
            std::vector<Expiry*> of_v;
            const auto& t = s.mesh.table();
            for (const Corner_index f : t.facets())
                for (std::size_t k = 0; k < 4; ++k)
                    if (bicell_sites(t, f)[k].vertex == v) of_v.push_back(expiries(s, f)[k]);
            std::vector<Rational> before;
            for (Expiry* e : of_v) {
                *e = Expiry::lower(1.0 + std::ldexp(integer(random, 0, 9), -20));
                before.push_back(Rational(e->path_length()) - Rational(base));
            }
            s[List{}][at(v)].base = base;
            s.call(Rebase{}, v);
            RC_ASSERT(s[List{}][at(v)].base == 0.0);
            for (std::size_t k = 0; k < of_v.size(); ++k)
                if (*of_v[k] != Expiry::never()) RC_ASSERT(Rational(of_v[k]->path_length()) <= before[k]);
        }
    }));
}

TEST_CASE("A vertex without a tolerance that moves so little that the square is 0 does not pass",
          "[relocation][rounding]") {
    // A square: every tolerance is 0.
    const std::vector<Point> square{{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    const Point moved{0x1p-600, 0};
    SECTION("tolerances") {
        Delaunay_mesh<2> mesh;
        Tolerance_strategy<2> strategy(mesh);
        Move_result report;
        mesh.build(square);
        strategy.recompute_tolerances(square, report);
        auto x = square;
        x[0] = moved;
        strategy.move_all(x, report);
        CHECK(report.moves.within_tolerance == 3U);
    }
    SECTION("paper") {
        Delaunay_mesh<2> mesh;
        Paper_strategy<2> strategy(mesh, Paper_choice{}, Tolerance_kind::floating, 0U);
        Move_result report;
        mesh.build(square);
        strategy.recompute_tolerances(square, report);
        strategy.move(0, moved, report);
        CHECK(report.moves.within_tolerance == 0U);
    }
}
