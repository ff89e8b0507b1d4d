// SPDX-License-Identifier: GPL-3.0-or-later
// The stages in 3D: soundness against rational numbers and MPFI, tightness, each stage compared with the next, their
// ranges.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/oracle_3.h>
#include <support/repeats.h>
#include <support/stages_3.h>

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/circumsphere_3.h>
#include <annulus/predicate/exact_sign.h>
#include <annulus/predicate/orientation_sign.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

/// As in tightness_test.cpp.
constexpr double filter_gives_away = 4 * bounds::filter_slack + 16 * bounds::filter_slack * bounds::filter_slack;
constexpr double interval_gives_away = bounds::interval_slack * (1 + 0x1p-40);

bool is_sane(const Certificate_value& v) {
    if (v.sign <= 0) return v.tolerance == 0.0;
    return v.tolerance >= 0.0 && std::isfinite(v.tolerance);
}

/// The truth is below y (1 + share), or y is next to it where numbers are subnormal.
bool is_near(const Truth_3& truth, double y, double share) {
    const double above = std::max(y / (1 - share) * (1 + 0x1p-50), y + 0x1p-1073);
    return !truth.is_at_least(above);
}

template <class Case>
void check_answers(const Case& x, const Answers& a, const Truth_3& truth) {
    HOLDS(a.exact.sign == truth.sign() && a.exact.stage == Stage::exact && is_sane(a.exact), x);
    HOLDS(!a.filter || (a.filter->sign == truth.sign() && a.filter->stage == Stage::filter && is_sane(*a.filter)), x);
    HOLDS(!a.floating || a.floating->sign == truth.sign(), x);
    HOLDS(!a.interval || (a.interval->sign == truth.sign() && is_sane(*a.interval)), x);
    HOLDS(!a.interval || a.interval->stage == Stage::interval, x);
    HOLDS(!a.filter || a.floating, x);
    if (truth.sign() <= 0) return;
    // Lower bounds; the exact one is the largest double that is.
    HOLDS(!a.filter || truth.is_at_least(a.filter->tolerance), x);
    HOLDS(!a.interval || truth.is_at_least(a.interval->tolerance), x);
    HOLDS(truth.is_at_least(a.exact.tolerance), x);
    HOLDS(!truth.is_at_least(std::nextafter(a.exact.tolerance, HUGE_VAL)), x);
    HOLDS(!a.filter || a.filter->tolerance <= a.exact.tolerance, x);
    HOLDS(!a.interval || a.interval->tolerance <= a.exact.tolerance, x);
    HOLDS(!a.filter || is_near(truth, a.filter->tolerance, filter_gives_away), x);
    HOLDS(!a.interval || is_near(truth, a.interval->tolerance, interval_gives_away), x);
    const Enclosure half_width = truth.enclosure();
    HOLDS(!half_width.is_below(a.exact.tolerance), x);
    HOLDS(!a.filter || !half_width.is_below(a.filter->tolerance), x);
    HOLDS(!a.interval || !half_width.is_below(a.interval->tolerance), x);
}

std::uint8_t wrong_side(const Bicell_3& c) {
    std::uint8_t bits = 0;
    for (std::size_t k = 1; k < partitions_3; ++k)
        if (!Annulus_truth(c, k).is_forward()) bits = static_cast<std::uint8_t>(bits | (1U << k));
    return bits;
}

bool same(const Certificate_value& l, const Certificate_value& r) {
    return l.tolerance == r.tolerance && l.sign == r.sign && l.stage == r.stage && l.wrong_side == r.wrong_side;
}

struct Leavers {
    int asked = 0, floating = 0, filter = 0, interval = 0, wrong_side = 0;

    void count(const Answers& a) {
        ++asked;
        floating += !a.floating;
        filter += !a.filter;
        interval += !a.filter && !a.interval;
        wrong_side += a.exact.wrong_side != 0;
    }
    void print(std::string_view name) const {
        const auto share = [this](int n) { return 100.0 * n / asked; };
        std::printf("| %s | %.2f | %.2f | %.2f | %.0f |\n", std::string(name).c_str(), share(floating), share(filter),
                    share(interval), share(wrong_side));
    }
};

}  // namespace

TEST_CASE("tetrahedra: every stage is sound, tight and has the exact sign", "[certificate][space]") {
    REQUIRE(for_all("of every family", [](const Seed& seed) {
        for_each_tetrahedron(seed.random(), 2, [](const Tetrahedron& t) {
            check_answers(t, answers_of(t), Tetrahedron_truth(t));
            const int truth = exact_orientation(t.a, t.b, t.c, t.d);
            HOLDS(exact_orientation_sign(t.tuple()).sign == truth, t);
            HOLDS(orientation_sign(t.tuple()) == 0 || orientation_sign(t.tuple()) == truth, t);
        });
    }));
}

TEST_CASE("bi-cells of space: every stage is sound, tight and has the exact sign", "[certificate][space]") {
    REQUIRE(for_all("of every family, with both signs", [](const Seed& seed) {
        for_each_bicell_3(seed.random(), 1, [](const Bicell_3& c) {
            check_answers(c, answers_of(c, Cell_widths::never), Bicell_3_truth(c, false));
            const int truth = Bicell_3_truth(c, false).sign();
            HOLDS(exact_empty_sphere_sign(c.tuple()).sign == truth, c);
            const Circumsphere_3 sphere(c.a, c.b, c.c, c.q);
            HOLDS(!sphere.positive() || !sphere.contains(c.p) || truth < 0, c);
        });
    }));
    REQUIRE(for_all("of every family, Delaunay, with cells", [](const Seed& seed) {
        for_each_delaunay_bicell_3(seed.random(), 1, [](const Bicell_3& c) {
            check_answers(c, answers_of(c, Cell_widths::always), Bicell_3_truth(c, true));
        });
    }));
}

TEST_CASE("which partitions are on their wrong side, and the cells that stand in for them", "[certificate][space]") {
    REQUIRE(for_all("in bi-cells of every family", [](const Seed& seed) {
        for_each_delaunay_bicell_3(seed.random(), 1, [](const Bicell_3& c) {
            const Answers never = answers_of(c, Cell_widths::never), needed = answers_of(c, Cell_widths::where_needed),
                          always = answers_of(c, Cell_widths::always);
            if (never.exact.sign == 0) return;
            const std::uint8_t truth = wrong_side(c);
            HOLDS(
                never.exact.wrong_side == truth && needed.exact.wrong_side == truth && always.exact.wrong_side == truth,
                c);
            // A stage may not be certain; then it reports the partition as on the wrong side.
            HOLDS(!needed.filter || (needed.filter->wrong_side & truth) == truth, c);
            HOLDS(!needed.interval || (needed.interval->wrong_side & truth) == truth, c);
            HOLDS(needed.exact.tolerance == (truth != 0 ? always : never).exact.tolerance, c);
            // The widths of cells count for a stage that is not certain, and only then.
            const auto agrees = [&](auto stage) {
                const std::optional<Certificate_value>& v = needed.*stage;
                if (!v || v->sign < 0) return true;
                const std::optional<Certificate_value>& other = (v->wrong_side != 0 ? always : never).*stage;
                return other && other->tolerance == v->tolerance;
            };
            HOLDS(agrees(&Answers::filter) && agrees(&Answers::interval), c);
            const double cells = std::min(orientation_exact(c.cell_p().tuple()).tolerance,
                                          orientation_exact(c.cell_q().tuple()).tolerance);
            HOLDS(always.exact.tolerance == std::min(never.exact.tolerance, cells), c);
            // The annuli one by one.
            const Annuli annuli = annuli_exact(c.tuple());
            HOLDS(never.exact.tolerance == *std::min_element(annuli.half_width.begin(), annuli.half_width.end()), c);
            HOLDS(annuli.sign == never.exact.sign && annuli.side[abc_pq] > 0, c);
            for (std::size_t k = 0; k < partitions_3; ++k) {
                const Annulus_truth one(c, k);
                HOLDS(one.is_at_least(annuli.half_width[k]), c);
                HOLDS(!one.is_at_least(std::nextafter(annuli.half_width[k], HUGE_VAL)), c);
                HOLDS((annuli.side[k] > 0) == one.is_forward(), c);
            }
        });
    }));
}

TEST_CASE("the filtered predicate in 3D gives the answer of its first stage that has one", "[certificate][space]") {
    REQUIRE(for_all("on tetrahedra and bi-cells", [](const Seed& seed) {
        for_each_tetrahedron(seed.random(), 2, [](const Tetrahedron& t) {
            const Answers a = answers_of(t);
            const Certificate_value rest = a.interval ? *a.interval : a.exact;
            HOLDS(same(evaluate_orientation(t.tuple(), true), a.filter ? *a.filter : rest), t);
            HOLDS(same(evaluate_orientation(t.tuple(), false), a.floating ? *a.floating : rest), t);
        });
        for_each_bicell_3(seed.random(), 2, [](const Bicell_3& c) {
            for (const Cell_widths cells : all_cells) {
                const Answers a = answers_of(c, cells);
                const Certificate_value rest = a.interval ? *a.interval : a.exact;
                HOLDS(same(evaluate_empty_sphere(c.tuple(), true, cells), a.filter ? *a.filter : rest), c);
                HOLDS(same(evaluate_empty_sphere(c.tuple(), false, cells), a.floating ? *a.floating : rest), c);
            }
        });
        RC_ASSERT(std::fegetround() == FE_TONEAREST);
    }));
}

TEST_CASE("the filter in space answers in its whole range and nowhere else", "[certificate][space]") {
    const auto corner_of = [](double x) { return Tetrahedron{{0, 0, 0}, {x, 0, 0}, {0, x, 0}, {0, 0, x}}; };
    const auto pair_of = [](double x) {
        return Bicell_3{
            {x, 0, 0}, {-0.5 * x, 0.75 * x, 0}, {-0.5 * x, -0.75 * x, 0}, {0, 0, -1.3 * x}, {0, 0.05 * x, 1.3 * x}};
    };
    // The largest difference of the pair is 1.5 x.
    const double most = bounds::filter_range_3, least = 1 / bounds::filter_range_3;
    for (const double x : {least, std::nextafter(least, 1.0), 1.0, std::nextafter(most, 1.0), most}) {
        INFO("x = " << as_code(x));
        CHECK(answers_of(corner_of(x)).filter);
        CHECK(answers_of(pair_of(x / 1.5), Cell_widths::always).exact.sign == 1);
        CHECK(answers_of(pair_of(0.625 * x), Cell_widths::always).filter.has_value() == (0.625 * 1.5 * x >= least));
    }
    for (const double x :
         {std::nextafter(least, 0.0), std::nextafter(most, HUGE_VAL), 0x1p-1074, 0x1p-1060, 0x1p-1022, 0x1p498}) {
        INFO("x = " << as_code(x));
        CHECK(!answers_of(corner_of(x)).filter);
        CHECK(!answers_of(corner_of(x)).floating);
        CHECK(evaluate_orientation(corner_of(x).tuple()).stage == Stage::interval);
        CHECK(evaluate_orientation(corner_of(x).tuple()).sign == 1);
        const double half = 0.5 / std::sqrt(3.0) * x;  // the altitude over the large facet is x / sqrt(3)
        CHECK(evaluate_orientation(corner_of(x).tuple()).tolerance <= half * (1 + 1e-14));
        CHECK(evaluate_orientation(corner_of(x).tuple()).tolerance >= half * (1 - 1e-11) - 0x1p-1074);
    }
    for (const double x : {most, 0x1p-300, 0x1p498}) {
        INFO("x = " << as_code(x));
        CHECK(!answers_of(pair_of(x), Cell_widths::always).filter);
        CHECK(evaluate_empty_sphere(pair_of(x).tuple()).stage == Stage::interval);
    }
}

TEST_CASE("the filter in space looks at every coordinate before it answers", "[certificate][space]") {
    // One coordinate beyond the range, all the others within.
    const double x = bounds::filter_range_3;
    for (std::size_t coordinate = 3; coordinate < 15; ++coordinate) {
        Bicell_3 c{
            {0, 0, 0}, {0.9 * x, 0, 0}, {0, 0.9 * x, 0}, {0.1 * x, 0.1 * x, -0.9 * x}, {0.2 * x, 0.2 * x, 0.9 * x}};
        const std::array<Point_3*, 5> points{&c.a, &c.b, &c.c, &c.p, &c.q};
        (*points[coordinate / 3])[coordinate % 3] = (coordinate == 11 ? -1.25 : 1.25) * x;
        INFO(as_code(c));
        CHECK(!answers_of(c, Cell_widths::never).filter);
        CHECK(!answers_of(c, Cell_widths::never).floating);
        const Tetrahedron t = coordinate < 9 ? c.cell_q() : Tetrahedron{c.a, c.b, c.c, coordinate < 12 ? c.p : c.q};
        CHECK(!answers_of(t).filter);
        CHECK(!answers_of(t).floating);
    }
}

TEST_CASE("half widths of space known in closed form", "[certificate][space]") {
    SECTION("a regular tetrahedron: its width is that of its edges, side / sqrt(2)") {
        const Tetrahedron t{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};  // side sqrt(8), width 2
        const Certificate_value v = orientation_exact(t.tuple());
        REQUIRE(std::abs(v.sign) == 1);
        const Tetrahedron positive = v.sign > 0 ? t : Tetrahedron{t.b, t.a, t.c, t.d};
        CHECK(orientation_exact(positive.tuple()).tolerance == 1.0);
        CHECK(evaluate_orientation(positive.tuple()).tolerance == Approx(1.0).epsilon(1e-12));
        CHECK(evaluate_orientation(positive.tuple()).tolerance <= 1.0);
    }
    SECTION("two spheres around the origin, radii 1 and 3: half width 1, exactly") {
        const Bicell_3 c{{1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -3}, {0, 0, 3}};
        REQUIRE(exact_orientation(c.a, c.b, c.c, c.q) > 0);
        const Annuli annuli = annuli_exact(c.tuple());
        CHECK(annuli.half_width[abc_pq] == 1.0);
        CHECK(paper_annulus(c.tuple()) == Approx(1.0).epsilon(1e-14));
    }
    SECTION("corners of a cube: half width 0") {
        const Bicell_3 c{{0, 0, 0}, {1, 1, 0}, {0, 1, 1}, {0, 1, 0}, {1, 0, 1}};
        CHECK(empty_sphere_exact(c.tuple()).sign == 0);
        CHECK(evaluate_empty_sphere(c.tuple()).stage == Stage::exact);
        CHECK(evaluate_empty_sphere(c.tuple()).tolerance == 0.0);
    }
    SECTION("the paper's slab is the altitude over the facet given first") {
        const Tetrahedron t{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}};
        CHECK(paper_slab(t.tuple()) == 1.5);
    }
}

TEST_CASE("how often each stage in space passes the question on", "[certificate][space][failure-rates]") {
    Random random(22);
    const int each = repeats(2000);
    const auto head = [](const char* what) {
        std::printf(
            "\n| %s: left to the next stage, %% | sign only, by filter | filter | interval | wrong side "
            "|\n|---|---|---|---|---|\n",
            what);
    };
    head("tetrahedra");
    for (const Family_3 family : all_families_3) {
        Leavers leavers;
        for (int i = 0; i < each; ++i) leavers.count(answers_of(tetrahedron(family, random)));
        leavers.print(name_of(family));
        if (family == Family_3::uniform) CHECK(leavers.filter < each / 100);
    }
    head("bi-cells in space");
    for (const Family_3 family : all_families_3) {
        Leavers leavers;
        for (int i = 0; i < each; ++i) leavers.count(answers_of(bicell(family, random), Cell_widths::never));
        leavers.print(name_of(family));
        if (family == Family_3::uniform) CHECK(leavers.filter < each / 50);
    }
    std::fflush(stdout);
}
