// SPDX-License-Identifier: GPL-3.0-or-later
// The guarantee of a tolerance: points that move by less never change the sign, and points that move a little farther
// in the worst directions do.

#include <support/arbitrary.h>
#include <support/catch.h>
#include <support/oracle.h>
#include <support/stages.h>

#include <gmpxx.h>

#include <cmath>

using namespace annulus;
using namespace annulus::testing;

namespace {

Point moved(const Point& p, const Point& direction, double length) {
    return {p[0] + length * direction[0], p[1] + length * direction[1]};
}

/// |x - y| compared with length, exactly.
int compare_distance(const Point& x, const Point& y, double length) {
    const mpq_class dx = mpq_class(x[0]) - mpq_class(y[0]), dy = mpq_class(x[1]) - mpq_class(y[1]);
    const mpq_class difference = dx * dx + dy * dy - mpq_class(length) * mpq_class(length);
    return sgn(difference);
}

template <class Case>
double largest_coordinate(const Case& x) {
    double largest = 0;
    for (const Point* p : x.tuple()) largest = std::max({largest, std::fabs((*p)[0]), std::fabs((*p)[1])});
    return largest;
}

/// Whether the tolerance is so large compared with the spacing of doubles there that a ten-thousandth of it is
/// representable.
template <class Case>
bool has_room(const Case& x, double tolerance) {
    return tolerance > largest_coordinate(x) * 0x1p-35 && tolerance > 0x1p-1000;
}

Bicell displaced(const Bicell& c, const std::array<Point, 4>& directions, double length) {
    return {moved(c.a, directions[0], length), moved(c.b, directions[1], length), moved(c.p, directions[2], length),
            moved(c.q, directions[3], length)};
}

/// Facet points away from the centre of the annulus, the others towards it: all of them onto the median circle.
std::array<Point, 4> worst_directions(const Bicell& c) {
    std::array<Point, 4> directions = Bicell_truth(c).outward();
    for (std::size_t i = 2; i < 4; ++i)
        for (double& x : directions[i]) x = -x;
    return directions;
}

Point any_direction(Random& random) {
    const double angle = between(random, 0, 6.283185307179586);
    return {std::cos(angle), std::sin(angle)};
}

bool is_closer(const Bicell& x, const Bicell& y, double length) {
    return compare_distance(x.a, y.a, length) < 0 && compare_distance(x.b, y.b, length) < 0 &&
           compare_distance(x.p, y.p, length) < 0 && compare_distance(x.q, y.q, length) < 0;
}

int sign_of(const Bicell& c) { return exact_empty_circle(c.a, c.b, c.q, c.p); }

struct Tried {
    int inside = 0, outside = 0;
};

void check_bicell(const Bicell& c, Random& random, Tried& tried) {
    const Certificate_value best = empty_sphere_exact(c.tuple());
    if (best.sign <= 0 || !has_room(c, best.tolerance)) return;
    const Certificate_value given = all_stages(c);
    const auto worst = worst_directions(c);

    for (int i = 0; i < 5; ++i) {
        // The worst directions first, then those of some points only, then random ones.
        auto directions = worst;
        if (i == 1 || i == 2)
            for (Point& d : directions)
                if (random() % 2 == 0) d = {0, 0};
        if (i > 2)
            for (Point& d : directions) d = any_direction(random);
        const Bicell x = displaced(c, directions, 0.9999 * given.tolerance);
        HOLDS(is_closer(x, c, given.tolerance), c);
        if (!is_bicell(x)) continue;
        HOLDS(sign_of(x) > 0, c);
        ++tried.inside;
    }

    const Bicell beyond = displaced(c, worst, 1.0001 * best.tolerance);
    // Where an edge is short compared with the tolerance, a ten-thousandth of it destroys the convex position.
    if (!is_bicell(beyond) || !is_bicell(beyond.flipped())) return;
    HOLDS(sign_of(beyond) < 0, c);
    ++tried.outside;
}

/// The vertex of the least altitude (c) and the direction of that altitude, from the opposite side towards it.
Triangle from_the_longest_side(const Triangle& t) {
    const auto square_of = [](const Point& p, const Point& q) {
        const mpq_class dx = mpq_class(p[0]) - mpq_class(q[0]), dy = mpq_class(p[1]) - mpq_class(q[1]);
        return mpq_class(dx * dx + dy * dy);
    };
    const mpq_class ab = square_of(t.a, t.b), bc = square_of(t.b, t.c), ca = square_of(t.c, t.a);
    if (ab >= bc && ab >= ca) return t;
    return bc >= ca ? t.rotated() : t.rotated().rotated();
}

void check_triangle(const Triangle& any, Random& random, Tried& tried) {
    const Triangle t = from_the_longest_side(any);
    const Certificate_value best = orientation_exact(t.tuple());
    if (best.sign <= 0 || !has_room(t, best.tolerance)) return;
    const Certificate_value given = all_stages(t);
    // The longest side to the left, the vertex over it to the right.
    const double x = t.b[0] - t.a[0], y = t.b[1] - t.a[1], length = std::hypot(x, y);
    const Point up{-y / length, x / length}, down{y / length, -x / length};
    const auto displaced_triangle = [&](double l) {
        return Triangle{moved(t.a, up, l), moved(t.b, up, l), moved(t.c, down, l)};
    };

    const Triangle inside = displaced_triangle(0.9999 * given.tolerance);
    HOLDS(compare_distance(inside.a, t.a, given.tolerance) < 0, t);
    HOLDS(exact_orientation(inside.a, inside.b, inside.c) > 0, t);
    const double l = 0.9999 * given.tolerance;
    const Triangle elsewhere{moved(t.a, any_direction(random), l), moved(t.b, any_direction(random), l),
                             moved(t.c, any_direction(random), l)};
    HOLDS(exact_orientation(elsewhere.a, elsewhere.b, elsewhere.c) > 0, t);
    ++tried.inside;
    const Triangle beyond = displaced_triangle(1.0001 * best.tolerance);
    HOLDS(exact_orientation(beyond.a, beyond.b, beyond.c) < 0, t);
    ++tried.outside;
}

}  // namespace

TEST_CASE("moves within the tolerance keep the empty circle, moves just beyond do not", "[certificate]") {
    Tried tried;
    int cases = 0;  // RC_PARAMS decides how many
    REQUIRE(for_all("of bi-cells of every family", [&tried, &cases](const Seed& seed) {
        ++cases;
        Random random = seed.random();
        for_each_delaunay_bicell(seed.random(), 3, [&](const Bicell& c) { check_bicell(c, random, tried); });
    }));
    CHECK(tried.inside > 50 * cases);
    CHECK(tried.outside > 10 * cases);
}

TEST_CASE("moves within the tolerance keep the orientation, moves just beyond do not", "[certificate]") {
    Tried tried;
    int cases = 0;  // RC_PARAMS decides how many
    REQUIRE(for_all("of triangles of every family", [&tried, &cases](const Seed& seed) {
        ++cases;
        Random random = seed.random();
        for_each_triangle(seed.random(), 6, [&](const Triangle& t) { check_triangle(t, random, tried); });
    }));
    CHECK(tried.inside > 10 * cases);
    CHECK(tried.outside > 10 * cases);
}

TEST_CASE("the tolerance of a whole bi-cell needs no condition on its triangles", "[certificate]") {
    REQUIRE(for_all("the least of the three certificates", [](const Seed& seed) {
        Random random = seed.random();
        for_each_delaunay_bicell(seed.random(), 3, [&random](const Bicell& c) {
            const Certificate_value circle = all_stages(c), left = all_stages(Triangle{c.a, c.b, c.q}),
                                    right = all_stages(Triangle{c.b, c.a, c.p});
            const double tolerance = std::min({circle.tolerance, left.tolerance, right.tolerance});
            if (circle.sign <= 0 || !has_room(c, tolerance)) return;
            for (int i = 0; i < 3; ++i) {
                auto directions = worst_directions(c);
                if (i > 0)
                    for (Point& d : directions) d = any_direction(random);
                const Bicell x = displaced(c, directions, 0.9999 * tolerance);
                HOLDS(is_closer(x, c, tolerance), c);
                HOLDS(is_bicell(x), c);
                HOLDS(sign_of(x) > 0, c);
            }
        });
    }));
}
