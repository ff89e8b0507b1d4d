// SPDX-License-Identifier: GPL-3.0-or-later
// Each stage compared with the next, and with the filtered predicate made of them.

#include <annulus/options.h>
#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/repeats.h>
#include <support/stages.h>

#include <cfenv>
#include <cmath>
#include <cstdio>

using namespace annulus;
using namespace annulus::testing;

namespace {

bool same(const Certificate_value& l, const Certificate_value& r) {
    return l.tolerance == r.tolerance && l.sign == r.sign && l.stage == r.stage;
}

template <class Case>
void check_order(const Case& x) {
    const Answers answers = answers_of(x);
    // The exact stage gives the largest double not above the truth, up to 2^-100: others can be one unit above it.
    const double top = std::nextafter(answers.exact.tolerance, HUGE_VAL);
    HOLDS(!answers.filter || answers.filter->tolerance < top, x);
    HOLDS(!answers.interval || answers.interval->tolerance < top, x);
    HOLDS(!answers.filter || answers.filter->sign == answers.exact.sign, x);
    HOLDS(!answers.interval || answers.interval->sign == answers.exact.sign, x);
    // A correctly rounded tolerance comes with the sign.
    HOLDS(!answers.filter || answers.floating, x);
}

template <class Case>
void check_stages(const Case& x) {
    const Answers answers = answers_of(x);
    const Certificate_value rest = answers.interval ? *answers.interval : answers.exact;
    HOLDS(same(all_stages(x, true), answers.filter ? *answers.filter : rest), x);
    HOLDS(same(all_stages(x, false), answers.floating ? *answers.floating : rest), x);
    HOLDS(std::fegetround() == FE_TONEAREST, x);
}

struct Leavers {
    int asked = 0, floating = 0, filter = 0, interval = 0;

    void count(const Answers& a) {
        ++asked;
        floating += !a.floating;
        filter += !a.filter;
        interval += !a.filter && !a.interval;
    }
    void print(std::string_view name) const {
        const auto share = [this](int n) { return 100.0 * n / asked; };
        std::printf("| %s | %.2f | %.2f | %.2f |\n", std::string(name).c_str(), share(floating), share(filter),
                    share(interval));
    }
};

}  // namespace

TEST_CASE("no stage gives more than the exact one", "[certificate]") {
    REQUIRE(for_all("on triangles", [](const Seed& seed) {
        for_each_triangle(seed.random(), 8, [](const Triangle& t) { check_order(t); });
    }));
    REQUIRE(for_all("on bi-cells", [](const Seed& seed) {
        for_each_bicell(seed.random(), 6, [](const Bicell& c) { check_order(c); });
    }));
}

TEST_CASE("the filtered predicate gives the answer of its first stage that has one", "[certificate]") {
    REQUIRE(for_all("on triangles", [](const Seed& seed) {
        for_each_triangle(seed.random(), 4, [](const Triangle& t) { check_stages(t); });
    }));
    REQUIRE(for_all("on bi-cells", [](const Seed& seed) {
        for_each_bicell(seed.random(), 4, [](const Bicell& c) { check_stages(c); });
    }));
}

TEST_CASE("each stage has inputs it answers", "[certificate]") {
    CHECK(all_stages(Triangle{{0, 0}, {1, 0}, {0, 1}}).stage == Stage::filter);
    CHECK(all_stages(Triangle{{0, 0}, {0x1p-300, 0}, {0, 0x1p-300}}).stage == Stage::interval);
    CHECK(all_stages(Triangle{{0, 0}, {1, 1}, {2, 2}}).stage == Stage::exact);
    CHECK(all_stages(Bicell{{0, -1}, {0, 1}, {3, 0}, {-3, 0}}).stage == Stage::filter);
    CHECK(all_stages(Bicell{{0, -0x1p400}, {0, 0x1p400}, {0x1p402, 0}, {-0x1p402, 0}}).stage == Stage::interval);
    CHECK(all_stages(Bicell{{0, 0}, {1, 1}, {1, 0}, {0, 1}}).stage == Stage::exact);
    // The interval stage scales, so that it decides at both ends of the domain, too.
    for (const double x : {0x1p-1074, 0x1p-1060, 0x1p-1022, 0x1p498}) {
        INFO("x = " << as_code(x));
        CHECK(all_stages(Triangle{{0, 0}, {x, 0}, {0, x}}).stage == Stage::interval);
        CHECK(all_stages(Bicell{{0, -x}, {0, x}, {3 * x, 0}, {-3 * x, 0}}).stage == Stage::interval);
        CHECK(all_stages(Bicell{{0, -x}, {0, x}, {3 * x, 0}, {-3 * x, 0}}).tolerance <= x);
        CHECK(all_stages(Bicell{{0, -x}, {0, x}, {3 * x, 0}, {-3 * x, 0}}).tolerance >= x * (1 - 0x1p-40) - 0x1p-1074);
    }
}

TEST_CASE("the filter looks at every difference before it answers", "[certificate]") {
    // One vector beyond the range, all the others within.
    const double x = bounds::filter_range;
    const Bicell by_b{{0, 0}, {1.25 * x, 0}, {0.6 * x, -0.4 * x}, {0.6 * x, 0.5 * x}};
    const Bicell by_p{{0, 0}, {x, 0}, {1.25 * x, -0.1 * x}, {0.6 * x, 0.5 * x}};
    const Bicell by_q{{0, 0}, {x, 0}, {0.6 * x, -0.5 * x}, {1.25 * x, 0.1 * x}};
    const Bicell by_e{{0, 0}, {x, 0}, {0.5 * x, -0.6 * x}, {0.5 * x, 0.6 * x}};
    for (const Bicell& c : {by_b, by_p, by_q, by_e}) {
        INFO(as_code(c));
        REQUIRE(is_bicell(c));
        CHECK(!answers_of(c).filter);
        CHECK(!answers_of(c).floating);
    }
    for (const Triangle& t :
         {Triangle{{0, 0}, {1.25 * x, 0}, {0.5 * x, 0.5 * x}}, Triangle{{0, 0}, {x, 0}, {0.5 * x, 1.25 * x}}}) {
        INFO(as_code(t));
        CHECK(!answers_of(t).filter);
        CHECK(!answers_of(t).floating);
    }
}

TEST_CASE("the filter answers in its whole range and nowhere else", "[certificate]") {
    const auto triangle_of = [](double x) { return Triangle{{0, 0}, {x, 0}, {0, x}}; };
    const auto kite_of = [](double x) { return Bicell{{0.5 * x, -0.25 * x}, {0.5 * x, 0.25 * x}, {x, 0}, {0, 0}}; };
    const double most = bounds::filter_range, least = 1 / bounds::filter_range;
    for (const double x : {least, std::nextafter(least, 1.0), 1.0, std::nextafter(most, 1.0), most}) {
        INFO("x = " << as_code(x));
        CHECK(answers_of(triangle_of(x)).filter);
        CHECK(answers_of(kite_of(x)).filter);
    }
    for (const double x : {std::nextafter(least, 0.0), std::nextafter(most, HUGE_VAL), 0x1p-1074, 0x1p500}) {
        INFO("x = " << as_code(x));
        CHECK(!answers_of(triangle_of(x)).filter);
        CHECK(!answers_of(triangle_of(x)).floating);
        CHECK(!answers_of(kite_of(x)).filter);
        CHECK(!answers_of(kite_of(x)).floating);
        CHECK(all_stages(triangle_of(x)).sign == 1);
    }
}

// Shown in bench/README.md: annulus-tests '[failure-rates]' prints the tables.
TEST_CASE("how often each stage passes the question on", "[certificate][failure-rates]") {
    Random random(22);
    const int each = repeats(2000);
    const auto head = [](const char* what) {
        std::printf(
            "\n| %s: left to the next stage, %% | sign only, by filter | filter | interval |\n|---|---|---|---|\n",
            what);
    };
    head("triangles");
    for (const Triangle_family family : all_triangle_families) {
        Leavers leavers;
        for (int i = 0; i < each; ++i) leavers.count(answers_of(triangle(family, random)));
        leavers.print(name_of(family));
        if (family == Triangle_family::uniform) CHECK(leavers.filter * 1000 < each);
    }
    head("bi-cells in the plane");
    for (const Bicell_family family : all_bicell_families) {
        Leavers leavers;
        for (int i = 0; i < each; ++i) leavers.count(answers_of(bicell(family, random)));
        leavers.print(name_of(family));
        if (family == Bicell_family::uniform) CHECK(leavers.filter * 1000 < each);
    }
    std::fflush(stdout);
}

TEST_CASE("kinds of tolerance have their names", "[certificate]") {
    STATIC_REQUIRE(name_of(Tolerance_kind::certified) == "certified");
    STATIC_REQUIRE(name_of(Tolerance_kind::paper) == "paper");
    STATIC_REQUIRE(name_of(Tolerance_kind::floating) == "floating");
}
