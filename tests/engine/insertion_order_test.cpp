// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which a rebuild inserts: who is in it, however vertices come and go, and when it is sorted anew.
#include <annulus/cgal/insertion_order.h>

#include <support/cases.h>
#include <support/catch.h>
#include <support/generators.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <vector>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
struct Crowd {
    std::vector<Coordinates<d>> x;
    std::vector<char> lives;
    Insertion_order<d> order;

    [[nodiscard]] std::vector<Index> use() {
        const auto is_living = [this](Index i) { return lives[static_cast<std::size_t>(i)] != 0; };
        const std::span<const Index> used = order.of(x, is_living, 1);
        return {used.begin(), used.end()};
    }
    [[nodiscard]] std::set<Index> living() const {
        std::set<Index> all;
        for (std::size_t i = 0; i < lives.size(); ++i)
            if (lives[i] != 0) all.insert(static_cast<Index>(i));
        return all;
    }
    /// From one vertex to the next, in the mean.
    [[nodiscard]] double stride(const std::vector<Index>& used) const {
        double sum = 0.0;
        for (std::size_t k = 1; k < used.size(); ++k) {
            double square = 0.0;
            for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i) {
                const double way =
                    x[static_cast<std::size_t>(used[k])][i] - x[static_cast<std::size_t>(used[k - 1])][i];
                square += way * way;
            }
            sum += std::sqrt(square);
        }
        return sum / static_cast<double>(used.size());
    }
};

template <int d>
Coordinates<d> somewhere(Random& random) {
    Coordinates<d> p{};
    for (double& c : p) c = unit(random);
    return p;
}

template <int d>
Crowd<d> crowd(std::size_t n, Random& random) {
    Crowd<d> c;
    for (std::size_t i = 0; i < n; ++i) c.x.push_back(somewhere<d>(random));
    c.lives.assign(n, 1);
    return c;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Everybody who lives is inserted once, whoever comes and goes, dimension", "[order]",
                       ((int d), d), 2, 3) {
    for_each_seed(20, [](Random& random) {
        Crowd<d> c = crowd<d>(200 + random() % 200, random);
        for (int use = 0; use < 60; ++use) {  // beyond the uses of one sort
            for (std::size_t k = random() % 20; k > 0; --k) {
                const std::size_t i = random() % (c.x.size() + 2);
                const bool told = random() % 16 != 0;  // who is not told of is found
                if (i >= c.x.size()) {
                    if (told) c.order.note_coming(static_cast<Index>(c.x.size()));
                    c.x.push_back(somewhere<d>(random));
                    c.lives.push_back(1);
                } else if (c.lives[i] != 0) {
                    if (told) c.order.note_going(static_cast<Index>(i));
                    c.lives[i] = random() % 8 == 0 ? 1 : 0;  // it may have failed
                } else {
                    if (told) c.order.note_coming(static_cast<Index>(i));
                    c.lives[i] = random() % 8 == 0 ? 0 : 1;
                    c.x[i] = somewhere<d>(random);
                }
            }
            if (random() % 8 == 0) continue;
            if (random() % 16 == 0) c.order.forget();
            const std::vector<Index> used = c.use();
            REQUIRE(std::set<Index>(used.begin(), used.end()) == c.living());
            REQUIRE(used.size() == c.living().size());
        }
    });
}

TEMPLATE_TEST_CASE_SIG("An order serves until neighbours in it have gone far apart, dimension", "[order]", ((int d), d),
                       2, 3) {
    Random random(5);
    Crowd<d> c = crowd<d>(2000, random);
    CHECK(c.order.sorts(c.x));
    const std::vector<Index> first = c.use();
    CHECK_FALSE(c.order.sorts(c.x));
    const double stride = c.stride(first);
    const auto move_by = [&](double way) {
        for (auto& p : c.x)
            for (double& coordinate : p) coordinate += way * (2.0 * unit(random) - 1.0);
    };
    move_by(0.1 * stride);
    CHECK(c.use() == first);
    for (auto& p : c.x) p[0] += 10.0 * stride;  // all of them together
    CHECK(c.use() == first);
    move_by(10.0 * stride);
    CHECK(c.order.sorts(c.x));
    (void)c.use();
    CHECK_FALSE(c.order.sorts(c.x));
    int uses = 0;
    while (!c.order.sorts(c.x) && uses < 1000) {
        (void)c.use();
        ++uses;
    }
    CHECK(uses > 4);
    CHECK(uses < 1000);  // a sort from time to time, however little they move
}

namespace {

/// Where everybody is apart from those that are far away and at rest: anywhere, or in clusters so small that they are points.
enum class Rest { none, far_away, clusters };

template <int d>
Coordinates<d> place_of(std::size_t i, Rest rest, Random& random) {
    Coordinates<d> p = somewhere<d>(random);
    if (rest == Rest::clusters)
        for (double& c : p) c = static_cast<double>(i % 7) + std::ldexp(c, -30);
    return p;
}

}  // namespace

// From one vertex to the next in the order of the rebuild, beside an order that is new: how far a location walks. Whatever the unit is.
TEMPLATE_TEST_CASE_SIG("No rebuild is in an order that is much worse than a new one, dimension", "[order]",
                       ((int d), d), 2, 3) {
    constexpr std::size_t n = 3000;
    struct Scene {
        Rest rest;
        std::size_t still;  // of a hundred
    };
    for (const Scene scene : {Scene{Rest::none, 0}, Scene{Rest::far_away, 1}, Scene{Rest::far_away, 10},
                              Scene{Rest::clusters, 0}, Scene{Rest::none, 50}, Scene{Rest::none, 95}})
        for (const int exponent : {0, -300, -600, -900, 400}) {
            CAPTURE(d, static_cast<int>(scene.rest), scene.still, exponent);
            Random random(7);
            Crowd<d> c = crowd<d>(n, random);
            std::vector<Coordinates<d>> unscaled(n);
            const auto is_still = [&](std::size_t i) { return i % 100 < scene.still; };
            for (std::size_t i = 0; i < n; ++i) {
                unscaled[i] = place_of<d>(i, scene.rest, random);
                if (scene.rest == Rest::far_away && is_still(i))
                    for (double& coordinate : unscaled[i]) coordinate = 4000.0 * (coordinate - 0.5);
            }
            for (int step = 0; step < 12; ++step) {
                for (std::size_t i = 0; i < n; ++i) {
                    if (step > 0 && !is_still(i)) unscaled[i] = place_of<d>(i, scene.rest, random);
                    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k)
                        c.x[i][k] = std::ldexp(unscaled[i][k], exponent);
                }
                const std::vector<Index> used = c.use();
                Insertion_order<d> fresh;
                const std::span<const Index> sorted = fresh.of(
                    c.x, [](Index) { return true; }, 1);
                // Of those that are not far away, whose ways would be all there is.
                const auto ways = [&](std::span<const Index> order) {
                    double sum = 0.0;
                    for (std::size_t k = 1; k < order.size(); ++k) {
                        const std::size_t p = static_cast<std::size_t>(order[k - 1]),
                                          q = static_cast<std::size_t>(order[k]);
                        if (scene.rest == Rest::far_away && (is_still(p) || is_still(q))) continue;
                        double most = 0.0;
                        for (std::size_t i = 0; i < static_cast<std::size_t>(d); ++i)
                            most = std::max(most, std::fabs(unscaled[q][i] - unscaled[p][i]));
                        sum += most;
                    }
                    return sum;
                };
                REQUIRE(ways(used) < 1.6 * ways(sorted));
            }
        }
}

// One that stands very near to its neighbour, and then does not, or one that goes far away, is one.
TEMPLATE_TEST_CASE_SIG("Some that go anywhere do not make an order old, dimension", "[order]", ((int d), d), 2, 3) {
    Random random(8);
    Crowd<d> c = crowd<d>(4000, random);
    for (std::size_t i = 0; i < 5; ++i) {
        c.x[i] = c.x[i + 100];
        c.x[i][0] = std::nextafter(c.x[i][0], 1.0);
    }
    const std::vector<Index> first = c.use();
    for (std::size_t i = 0; i < 5; ++i) c.x[i][0] += 0.01;
    for (double& coordinate : c.x[2000]) coordinate = 0x1p490;
    CHECK_FALSE(c.order.sorts(c.x));
    CHECK(c.use() == first);
}

TEMPLATE_TEST_CASE_SIG("Who comes to another place is not inserted where it was, dimension", "[order]", ((int d), d), 2,
                       3) {
    Random random(6);
    Crowd<d> c = crowd<d>(4000, random);
    const double stride = c.stride(c.use());
    std::vector<std::size_t> turn(c.x.size());
    std::iota(turn.begin(), turn.end(), 0);
    std::shuffle(turn.begin(), turn.end(), random);
    for (std::size_t use = 0; use < 5;
         ++use) {  // a quarter of them in the end: whichever are looked at, some are among them
        for (std::size_t k = 200 * use; k < 200 * (use + 1); ++k) {
            c.order.note_going(static_cast<Index>(turn[k]));
            c.order.note_coming(static_cast<Index>(turn[k]));
            c.x[turn[k]] = somewhere<d>(random);
        }
        REQUIRE_FALSE(c.order.sorts(c.x));  // they do not count as having gone far
        const std::vector<Index> used = c.use();
        REQUIRE(used.size() == c.x.size());
        REQUIRE(c.stride(used) < 2.5 * stride);  // newcomers follow in an order of their own
    }
    // When they are many all are sorted.
    for (std::size_t i = 0; i < 1000; ++i) c.order.note_coming(static_cast<Index>(i));
    CHECK(c.order.sorts(c.x));
}
