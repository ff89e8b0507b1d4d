// SPDX-License-Identifier: GPL-3.0-or-later
// Several threads have the same results as one, in the same order.
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/degeneracy.h>
#include <annulus/mesh/parallel_runs.h>
#include <apps/motion/generated_points.h>

#include <support/catch.h>

#include <numeric>
#include <stdexcept>

using namespace annulus;

namespace {

/// All results, in the order of the calls.
template <int d>
std::vector<double> everything(const Corner_table<d>& t, const std::vector<Coordinates<d>>& x, int threads) {
    std::vector<double> said;
    const auto say = [&](auto y) { said.push_back(static_cast<double>(y)); };
    const auto say_stages = [&](const Stage_counts& s) {
        for (const auto n : {s.filter, s.interval, s.exact}) say(n);
    };
    const auto say_histogram = [&](const Histogram& h) {
        for (const std::uint64_t n : h.counts()) say(n);
        for (const double y : {h.min(), h.max()}) say(y);
        for (const std::uint64_t n : {h.underflow(), h.overflow(), h.total()}) say(n);
    };
    const auto say_distribution = [&](const Distribution& of) {
        say_histogram(of.histogram);
        said.insert(said.end(), of.quantiles.begin(), of.quantiles.end());
    };
    const auto say_widths = [&](const Width_counts& c) {
        say(c.total);
        say(c.zero);
        for (const std::uint64_t n : c.below) say(n);
        say_distribution(c.width);
    };
    Degeneracy_options<d> options;
    options.threads = threads;
    options.raw = [&](const Raw_certificate<d>& c) {
        say(static_cast<int>(c.kind));
        for (const Index v : c.point) say(v);
        for (const double y : {c.width_lower, c.width_upper, c.tolerance, c.theta}) say(y);
        say(static_cast<int>(c.stage));
    };
    options.unsound = [&](std::span<const Index> points) { said.insert(said.end(), points.begin(), points.end()); };
    const Degeneracy found = degeneracy(t, x, options);
    for (const Certificate_counts* c : {&found.bicells, &found.cells, &found.ridges}) {
        say_widths(c->least);
        say_stages(c->arithmetic);
        say(c->decided_exactly);
    }
    say_widths(found.standard);
    for (const std::uint64_t n : {found.non_convex, found.flat, found.vertices.zero, found.vertices.paper_above_exact,
                                  found.vertices.paper_unsound, found.vertices.unsound_certificates})
        say(n);
    for (const std::uint64_t n : found.vertices.below) say(n);
    say_stages(found.convexity);
    for (const Distribution* of : {&found.theta, &found.vertices.certified, &found.vertices.paper})
        say_distribution(*of);
    say_histogram(found.vertices.paper_ratio);
    return said;
}

template <int d>
void check(Point_family family, std::size_t n) {
    const std::vector<Coordinates<d>> x = generate<d>(family, n, 7);
    Delaunay_mesh<d> mesh;
    mesh.build(x);
    REQUIRE(mesh.dimension() == d);
    const std::vector<double> one = everything<d>(mesh.table(), x, 1);
    CHECK(one.size() > 5 * n);  // of more than one batch
    for (const int threads : {2, 3, 8}) {
        CAPTURE(threads);
        const std::vector<double> many = everything<d>(mesh.table(), x, threads);
        REQUIRE(many.size() == one.size());
        std::size_t differ = 0;
        for (std::size_t i = 0; i < one.size(); ++i)
            differ += one[i] == many[i] || (one[i] != one[i] && many[i] != many[i]) ? 0U : 1U;
        CHECK(differ == 0);
    }
}

}  // namespace

TEST_CASE("Several threads count what one counts and tell it in the same order", "[measure][degeneracy][deep]") {
    check<2>(Point_family::uniform, 20000);
    check<2>(Point_family::grid, 10000);
    check<2>(Point_family::cospherical, 10000);  // a circle: the border is long
    check<3>(Point_family::uniform, 4000);
    check<3>(Point_family::grid, 3375);
    check<3>(Point_family::cospherical, 3000);
}

TEST_CASE("A slot is taken before it is filled again, in order, and a fault ends all", "[mesh]") {
    for (const int threads : {1, 2, 7}) {
        CAPTURE(threads);
        int filled = 0;
        std::vector<int> taken;
        const auto run = [&](int faulty) {
            filled = 0;
            taken.clear();
            for_each_in_order<std::pair<int, int>>(
                threads,
                [&](auto& slot) {
                    slot = {filled, 0};
                    return ++filled <= 1000;
                },
                [&](auto& slot) {
                    if (slot.first == faulty) throw std::runtime_error("this one");
                    slot.second = 2 * slot.first;
                },
                [&](const auto& slot) { taken.push_back(slot.second); });
        };
        run(-1);
        std::vector<int> all(1000);
        for (int i = 0; i < 1000; ++i) all[static_cast<std::size_t>(i)] = 2 * i;
        CHECK(taken == all);
        CHECK_THROWS_AS(run(500), std::runtime_error);
        CHECK(taken.size() <= 500);
        CHECK(std::equal(taken.begin(), taken.end(), all.begin()));
    }
}
