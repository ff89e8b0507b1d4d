// SPDX-License-Identifier: GPL-3.0-or-later
#include "shapes.h"

#include <annulus/error.h>
#include <annulus/moving_delaunay_3.h>
#include <apps/motion/ball_3.h>
#include <apps/motion/dihedral.h>
#include <apps/motion/initial_mesh_3.h>
#include <apps/motion/nodt_3.h>
#include <apps/motion/surface_3.h>
#include <apps/motion/surface_stars.h>

#include <support/catch.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>
#include <set>

using namespace annulus;
using namespace annulus_test;

namespace {

using Points = std::vector<Coordinates<3>>;
using Real = long double;
using Vector = std::array<Real, 3>;

double distance(const Coordinates<3>& a, const Coordinates<3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

Cells_3 cells_of(const Points& points) {
    Options options;
    options.strategy = Strategy::rebuild;
    return linked(Moving_delaunay_3(points, options).audit_input().cells, points.size());
}

/// The body-centred cubic lattice with edge 1, scaled, inside a cube. No five of it that share a sphere are adjacent.
Points body_centred(int n, double scale) {
    Points points;
    for (int i = -n; i <= n; ++i)
        for (int j = -n; j <= n; ++j)
            for (int k = -n; k <= n; ++k)
                for (const double half : {0.0, 0.5})
                    points.push_back({scale * (i + half), scale * (j + half), scale * (k + half)});
    return points;
}

Vector minus(const Coordinates<3>& a, const Coordinates<3>& b) {
    return {Real{a[0]} - b[0], Real{a[1]} - b[1], Real{a[2]} - b[2]};
}
Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Real dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Solves for the point whose products with three rows are given (Cramer).
Vector solve(const Vector& r0, const Vector& r1, const Vector& r2, const Vector& b) {
    const Real det = dot(r0, cross(r1, r2));
    const Vector c0 = cross(r1, r2), c1 = cross(r2, r0), c2 = cross(r0, r1);
    Vector x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = (b[0] * c0[k] + b[1] * c1[k] + b[2] * c2[k]) / det;
    return x;
}

/// Circumcentre from equal distances, relative to the first point; a triangle's is in its plane.
Vector centre(const std::vector<Coordinates<3>>& p) {
    const Vector u = minus(p[1], p[0]), v = minus(p[2], p[0]);
    const Vector w = p.size() == 4 ? minus(p[3], p[0]) : cross(u, v);
    return solve(u, v, w, {dot(u, u) / 2, dot(v, v) / 2, p.size() == 4 ? dot(w, w) / 2 : 0});
}

/// The definition, word by word, in long double and with maps.
Points targets_by_definition(const Domain_3& domain, const std::vector<char>& on_surface, const Points& x,
                             const std::vector<std::array<Index, 4>>& cells) {
    const auto p = [&](Index i) { return x[static_cast<std::size_t>(i)]; };
    std::map<std::set<Index>, int> facets;
    std::vector<std::array<Index, 4>> inside;
    for (const auto& c : cells) {
        const Vector o = centre({p(c[0]), p(c[1]), p(c[2]), p(c[3])});
        Coordinates<3> at;
        for (std::size_t k = 0; k < 3; ++k) at[k] = static_cast<double>(p(c[0])[k] + o[k]);
        if (!domain.contains(at)) continue;
        inside.push_back(c);
        for (const Index leave : c) {
            std::set<Index> f(c.begin(), c.end());
            f.erase(leave);
            ++facets[f];
        }
    }
    std::vector<Vector> sum(x.size()), flat(x.size());
    std::vector<Real> weight(x.size(), 0), area(x.size(), 0);
    for (const auto& c : inside) {
        const Real volume = dot(minus(p(c[1]), p(c[0])), cross(minus(p(c[2]), p(c[0])), minus(p(c[3]), p(c[0])))) / 6;
        const Vector o = centre({p(c[0]), p(c[1]), p(c[2]), p(c[3])});
        for (const Index v : c) {
            weight[static_cast<std::size_t>(v)] += volume;
            for (std::size_t k = 0; k < 3; ++k) sum[static_cast<std::size_t>(v)][k] += volume * (o[k] + p(c[0])[k]);
        }
    }
    std::vector<Vector> normal(x.size(), Vector{});
    std::vector<std::map<Index, std::set<Index>>> link(x.size());
    std::vector<std::size_t> around(x.size(), 0);
    for (const auto& [facet, count] : facets) {
        if (count != 1) continue;
        const auto& f = facet;  // lambdas of clang before 16 cannot name what a structured binding does
        const std::vector<Index> t(f.begin(), f.end());
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = t[(k + 1) % 3], b = t[(k + 2) % 3];
            auto& edges = link[static_cast<std::size_t>(t[k])];
            edges[a].insert(b), edges[b].insert(a);
            ++around[static_cast<std::size_t>(t[k])];
        }
        const Vector n = cross(minus(p(t[1]), p(t[0])), minus(p(t[2]), p(t[0]))),
                     o = centre({p(t[0]), p(t[1]), p(t[2])});
        const Real a = std::sqrt(dot(n, n)) / 2;
        // The cell behind it is on the other side of the outer normal.
        const auto behind = std::find_if(inside.begin(), inside.end(), [&](const auto& c) {
            return std::all_of(t.begin(), t.end(),
                               [&](Index v) { return std::find(c.begin(), c.end(), v) != c.end(); });
        });
        const Index apex = *std::find_if(behind->begin(), behind->end(), [&](Index v) { return !f.contains(v); });
        const Real side = dot(n, minus(p(apex), p(t[0]))) < 0 ? 1 : -1;
        for (const Index v : t) {
            for (std::size_t k = 0; k < 3; ++k) normal[static_cast<std::size_t>(v)][k] += side * n[k];
            area[static_cast<std::size_t>(v)] += a;
            for (std::size_t k = 0; k < 3; ++k) flat[static_cast<std::size_t>(v)][k] += a * (o[k] + p(t[0])[k]);
        }
    }
    // A disc: every corner of the link has two neighbours there, and from one of them all are reached.
    const auto disc = [&](std::size_t v) {
        std::set<Index> reached;
        std::vector<Index> next;
        if (!link[v].empty()) next.push_back(link[v].begin()->first);
        while (!next.empty()) {
            const Index at = next.back();
            next.pop_back();
            if (!reached.insert(at).second) continue;
            if (link[v].at(at).size() != 2) return false;
            next.insert(next.end(), link[v].at(at).begin(), link[v].at(at).end());
        }
        return !reached.empty() && reached.size() == around[v];
    };
    Points target = x;
    for (std::size_t v = 0; v < x.size(); ++v) {
        if (weight[v] == 0) continue;
        Coordinates<3> at;
        if (on_surface[v] == 0) {
            for (std::size_t k = 0; k < 3; ++k) at[k] = static_cast<double>(sum[v][k] / weight[v]);
            if (domain.contains(at)) target[v] = at;
        } else if (disc(v)) {
            double nearest = 1e300;
            for (const auto& [w, ends] : link[v]) nearest = std::min(nearest, distance(x[v], p(w)));
            Vector way;
            for (std::size_t k = 0; k < 3; ++k) way[k] = flat[v][k] / area[v] - x[v][k];
            const Real across = dot(way, normal[v]) / dot(normal[v], normal[v]);
            for (std::size_t k = 0; k < 3; ++k) way[k] -= across * normal[v][k];
            const Real length = std::sqrt(dot(way, way)), share = std::min(Real{0.75}, nearest / 10 / length);
            for (std::size_t k = 0; k < 3; ++k) at[k] = static_cast<double>(x[v][k] + share * way[k]);
            target[v] = domain.project(at);
        }
    }
    return target;
}

}  // namespace

TEST_CASE("targets are those of the definition", "[motion][nodt]") {
    for (unsigned seed = 1; seed <= 4; ++seed) {
        const Ball_3 ball(1);
        const Surface_3 box_surface(box({1, 0.8, 0.6}));
        const Domain_3& domain = seed % 2 == 0 ? static_cast<const Domain_3&>(ball) : box_surface;
        Points points;
        for (auto p : random_points(900, seed)) {
            if (!domain.contains(p)) p = domain.project(p);
            points.push_back(p);
        }
        const Cells_3 cells = cells_of(points);
        Points target(points.size());
        const std::vector<char> on_surface = vertices_on_surface(domain, points);
        const Nodt_step step = Nodt_3(domain, Sizing_3(domain), on_surface)
                                   .step(cells, cells_inside(domain, cells, points), points, target);
        const Points expected = targets_by_definition(domain, on_surface, points, cells.vertex);
        for (std::size_t v = 0; v < points.size(); ++v) CHECK(distance(target[v], expected[v]) < 1e-9);
        CHECK(step.vertices <= points.size());
        CHECK(step.boundary > 50);
        CHECK(step.vertices > step.boundary + 100);
        CHECK(step.max_displacement > step.mean_displacement);
    }
}

TEST_CASE("the body-centred lattice is a fixed point, and locks where its angles say", "[motion][nodt]") {
    const Points points = body_centred(5, 0.18);
    const Ball_3 ball(0.9);
    const Cells_3 cells = cells_of(points);
    const auto inside = cells_inside(ball, cells, points);
    Points target(points.size());
    (void)Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points)).step(cells, inside, points, target);
    std::size_t interior = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (distance(points[v], {}) > 0.65) continue;
        ++interior;
        CHECK(distance(points[v], target[v]) < 1e-14);
    }
    CHECK(interior > 200);

    // Its dihedral angles are 60 and 90 degrees.
    Points moved = points;
    const std::size_t spoilt =
        static_cast<std::size_t>(std::find(points.begin(), points.end(), Coordinates<3>{}) - points.begin());
    REQUIRE(spoilt < points.size());
    moved[spoilt] = {0.006, 0.004, 0.002};
    const Cells_3 after = cells_of(moved);
    const auto inside_after = cells_inside(ball, after, moved);
    const Nodt_step all =
        Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points), 59.9).step(after, inside_after, moved, target);
    std::set<Index> near;
    for (const auto& c : after.vertex)
        if (std::find(c.begin(), c.end(), static_cast<Index>(spoilt)) != c.end()) near.insert(c.begin(), c.end());
    std::size_t locked = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        if (distance(points[v], {}) > 0.65) continue;
        locked += target[v] == moved[v];
        // A neighbour with a spoilt cell is unlocked and moves; all others rest.
        CHECK((target[v] == moved[v]) == !near.contains(static_cast<Index>(v)));
    }
    CHECK(locked + near.size() == interior);
    CHECK(all.locked >= locked);
    // 30 degrees leave room for the move.
    const Nodt_step loose =
        Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points), 30).step(after, inside_after, moved, target);
    CHECK(loose.locked > all.locked);
    CHECK(target[spoilt] == moved[spoilt]);
}

TEST_CASE("a free vertex goes where the energy of its star is least", "[motion][nodt]") {
    // The energy of natural ODT is the integral of the interpolation of |x|² on the mesh; of a fixed domain and
    // connectivity.
    const Ball_3 ball(1);
    for (unsigned seed = 20; seed < 24; ++seed) {
        Points points;
        for (const auto& p : random_points(700, seed)) points.push_back(ball.contains(p) ? p : ball.project(p));
        const Cells_3 cells = cells_of(points);
        const auto inside = cells_inside(ball, cells, points);
        Points target(points.size());
        (void)Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points)).step(cells, inside, points, target);
        std::set<Index> boundary;
        for (const auto& facet : surface_facets(cells, inside)) boundary.insert(facet.begin(), facet.end());
        std::size_t checked = 0;
        for (std::size_t v = 0; v < points.size(); ++v) {
            std::vector<std::array<Index, 4>> star;
            bool interior = !boundary.contains(static_cast<Index>(v));
            for (std::size_t c = 0; c < cells.size(); ++c)
                if (std::find(cells.vertex[c].begin(), cells.vertex[c].end(), static_cast<Index>(v)) !=
                    cells.vertex[c].end()) {
                    star.push_back(cells.vertex[c]);
                    interior = interior && inside[c] != 0;
                }
            if (!interior || target[v] == points[v]) continue;
            const auto energy = [&](const Coordinates<3>& x) {
                Real sum = 0;
                for (const auto& cell : star) {
                    std::array<Coordinates<3>, 4> q;
                    Real height = 0;
                    for (std::size_t i = 0; i < 4; ++i) {
                        q[i] = cell[i] == static_cast<Index>(v) ? x : points[static_cast<std::size_t>(cell[i])];
                        height += dot(minus(q[i], {}), minus(q[i], {}));
                    }
                    sum += height / 4 * dot(minus(q[1], q[0]), cross(minus(q[2], q[0]), minus(q[3], q[0]))) / 6;
                }
                return sum;
            };
            // A quadratic function of x: equal on both sides of its least value, and larger there.
            const Real least = energy(target[v]);
            for (std::size_t k = 0; k < 3; ++k) {
                Coordinates<3> a = target[v], b = target[v];
                a[k] += 0.01;
                b[k] -= 0.01;
                CHECK(energy(a) > least);
                CHECK(std::abs(static_cast<double>((energy(a) - energy(b)) / (energy(a) - least))) < 1e-8);
            }
            ++checked;
        }
        CHECK(checked > 100);
    }
}

TEST_CASE("boundary vertices stay on the surface, symmetric ones where they are", "[motion][nodt]") {
    Points points = round_octahedron(0).points;
    points.push_back({0, 0, 0});
    const Ball_3 ball(1);
    const Cells_3 cells = cells_of(points);
    Points target(points.size());
    const auto inside = cells_inside(ball, cells, points);
    const Nodt_step step =
        Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points)).step(cells, inside, points, target);
    CHECK(step.boundary == 6);
    CHECK(step.vertices == 7);
    for (std::size_t v = 0; v < points.size(); ++v) CHECK(distance(target[v], points[v]) < 1e-15);
}

TEST_CASE("which vertices are on the surface", "[motion][nodt]") {
    const Surface_3 surface(box({1, 0.8, 0.6}));
    const Coordinates<3> on_a_face = surface.project({0.1, 0.1, 0.2}), on_another = surface.project({0.7, 0.1, 0.2});
    const Points points{
        on_a_face, {0.1, 0.1, 0.2}, on_another, {0.1, 0.1, on_a_face[2] + 1e-12}, {0.1, 0.1, on_a_face[2] + 1e-6}};
    const auto on = vertices_on_surface(surface, points);
    for (std::size_t v = 0; v < points.size(); ++v)
        CHECK((on[v] != 0) == (distance(points[v], surface.project(points[v])) < 1e-8));
    CHECK(std::count(on.begin(), on.end(), 1) > 0);
    CHECK(std::count(on.begin(), on.end(), 0) > 0);
}

TEST_CASE("the facets around a vertex are a disc or not", "[motion][nodt]") {
    const Triangle_surface octahedron = round_octahedron(0);
    std::vector<std::array<Index, 3>> facets(octahedron.triangles.begin(), octahedron.triangles.end());
    REQUIRE(facets.size() == 8);
    {
        const Surface_stars stars(facets, 7);
        for (Index v = 0; v < 6; ++v) {
            CHECK(stars.around(v).size() == 4);
            CHECK(stars.disc(v));
        }
        CHECK_FALSE(stars.disc(6));  // no facets
    }
    {
        // A second one that shares a vertex with the first: two fans there.
        auto both = facets;
        for (auto f : facets) {
            for (Index& v : f)
                if (v != facets[0][0]) v += 6;
            both.push_back(f);
        }
        const Surface_stars stars(both, 12);
        for (const auto& f : both)
            for (const Index v : f) CHECK(stars.disc(v) == (v != facets[0][0]));
    }
    {
        const auto lost = facets.back();
        facets.pop_back();
        const Surface_stars stars(facets, 6);
        for (Index v = 0; v < 6; ++v) CHECK(stars.disc(v) == (std::find(lost.begin(), lost.end(), v) == lost.end()));
    }
    // Three sheets along an edge; two of them are a disc around its ends, the third is too much.
    const Surface_stars book(
        std::vector<std::array<Index, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 4}, {0, 4, 5}, {0, 5, 1}}, 6);
    CHECK_FALSE(book.disc(0));
}

TEST_CASE("vertices of the surface go by a tenth of the way to their nearest neighbour", "[motion][nodt]") {
    Points points = round_octahedron(2).points;
    points.push_back({0, 0, 0});
    points[0] = Ball_3(1).project({points[0][0] + 0.3, points[0][1] + 0.1, points[0][2] - 0.2});
    const Ball_3 ball(1);
    const Cells_3 cells = cells_of(points);
    const auto inside = cells_inside(ball, cells, points);
    Points target(points.size());
    const Nodt_step step =
        Nodt_3(ball, Sizing_3(ball), vertices_on_surface(ball, points)).step(cells, inside, points, target);
    CHECK(step.boundary + 1 == points.size());
    std::size_t full = 0;
    const auto facets = surface_facets(cells, inside);
    for (std::size_t v = 0; v + 1 < points.size(); ++v) {
        double nearest = 10;
        for (const auto& f : facets)
            if (std::find(f.begin(), f.end(), static_cast<Index>(v)) != f.end())
                for (const Index w : f)
                    if (w != static_cast<Index>(v))
                        nearest = std::min(nearest, distance(points[v], points[static_cast<std::size_t>(w)]));
        const double went = distance(points[v], target[v]);
        CHECK(went <= 0.1 * nearest * 1.01);  // the projection to the surface is added
        full += went > 0.07 * nearest;
    }
    CHECK(full > 0);
}

TEST_CASE("rows of a regular lattice that go against each other are damped", "[motion][nodt]") {
    const double off = 0.02;
    const Surface_3 surface(box({6, 6, 1}));
    Points points;
    for (int row = -3; row <= 3; ++row)
        for (int k = -4; k <= 4; ++k)
            points.push_back({row % 2 == 0 ? k : k + 0.5, std::sqrt(0.75) * row + (row % 2 == 0 ? off : -off), 1});
    const std::size_t middle = points.size() / 2;
    points.push_back({0, 0, -1});
    const Cells_3 cells = cells_of(points);
    Points target(points.size());
    (void)Nodt_3(surface, Sizing_3(surface), vertices_on_surface(surface, points))
        .step(cells, std::vector<char>(cells.size(), 1), points, target);
    // The mean is the mirror image of the position; the target is three quarters of the way there.
    CHECK(distance(points[middle], {0, off, 1}) < 1e-15);
    CHECK(distance(target[middle], {0, -off / 2, 1}) < 1e-12);
}

TEST_CASE("vertices of the surface do not exchange their places for ever", "[motion][nodt]") {
    const Ball_3 ball(1);
    Points points = round_octahedron(3).points;
    const Points noise = random_points(points.size(), 5);
    for (std::size_t v = 0; v < points.size(); ++v) {
        for (std::size_t k = 0; k < 3; ++k) points[v][k] += 1e-3 * noise[v][k];
        points[v] = ball.project(points[v]);
    }
    points.push_back({0, 0, 0});
    const Cells_3 cells = cells_of(points);
    const auto inside = cells_inside(ball, cells, points);
    const Nodt_3 nodt(ball, Sizing_3(ball), vertices_on_surface(ball, points));
    Points before, target(points.size());
    double there = 0, and_back = 0;
    for (int step = 0; step < 40; ++step) {
        (void)nodt.step(cells, inside, points, target);
        there = and_back = 0;
        for (std::size_t v = 0; v < points.size(); ++v) {
            there += distance(points[v], target[v]);
            if (step > 0) and_back += distance(before[v], target[v]);
        }
        before = points;
        points = target;
    }
    CHECK(and_back > 1.5 * there);  // on the way to rest: two steps are nearly twice as far as one
}

TEST_CASE("a tip of a surface stays where it is", "[motion][nodt]") {
    // A needle with twelve sides. Were its vertex drawn to the mean of its facets' circumcentres, it would slide down
    // the side.
    Triangle_surface needle;
    needle.points = {{0, 0, 4}, {0, 0, 0}};
    for (int i = 0; i < 12; ++i)
        needle.points.push_back({std::cos(std::numbers::pi * i / 6), std::sin(std::numbers::pi * i / 6), 0});
    for (Index i = 0; i < 12; ++i) {
        needle.triangles.push_back({0, 2 + i, 2 + (i + 1) % 12});
        needle.triangles.push_back({1, 2 + (i + 1) % 12, 2 + i});
    }
    const Surface_3 surface(needle);
    Points points = initial_mesh(surface, Sizing_3(surface), 400, 1);
    const auto from_tip = [&] {
        double nearest = 10;
        for (const auto& p : points) nearest = std::min(nearest, distance(p, {0, 0, 4}));
        return nearest;
    };
    const double before = from_tip();
    const Nodt_3 nodt(surface, Sizing_3(surface), vertices_on_surface(surface, points));
    for (int step = 0; step < 200; ++step) {
        const Cells_3 cells = cells_of(points);
        Points target(points.size());
        (void)nodt.step(cells, cells_inside(surface, cells, points), points, target);
        points = target;
    }
    INFO("from " << before << " to " << from_tip());
    CHECK(from_tip() < before + 0.1);
}

TEST_CASE("vertices on sharp edges stay on them, and corners where they are", "[motion][nodt][features]") {
    for (const double stretch : {1.0, 1.7}) {
        const Triangle_surface s = box({stretch, 0.8, 0.6});
        const Surface_3 surface(s);
        auto sharp = std::make_shared<const Feature_curves>(s, 30);
        Points points = initial_mesh(surface, Sizing_3(surface), 400, 1, sharp.get());
        sharp->snap(points, rounding_of(surface));
        const std::vector<Feature_curves::Place> place = sharp->places(points, rounding_of(surface));
        // Mesh_3 spaces them evenly.
        const Points noise = random_points(points.size(), 3);
        for (std::size_t v = 0; v < points.size(); ++v)
            if (const auto c = static_cast<Index>(place[v]); c >= 0) {
                const Polyline_3& curve = sharp->curves()[static_cast<std::size_t>(c)];
                points[v] = curve.at(curve.nearest(points[v]) + 0.03 * noise[v][0]);
            }
        const Points start = points;
        CHECK(std::count(place.begin(), place.end(), Feature_curves::Place::corner) == 8);
        const Nodt_3 nodt(surface, Sizing_3(surface), vertices_on_surface(surface, points), {}, 1,
                          Curve_motion(sharp, place));
        double gone = 0;
        for (int step = 0; step < 30; ++step) {
            const Cells_3 cells = cells_of(points);
            Points target(points.size());
            const Nodt_step done = nodt.step(cells, cells_inside(surface, cells, points), points, target);
            CHECK(done.kept >= 8);
            points = target;
        }
        for (std::size_t v = 0; v < points.size(); ++v) {
            if (place[v] == Feature_curves::Place::off) continue;
            int sides = 0, rests = 0;  // of the box, exactly
            for (std::size_t k = 0; k < 3; ++k) {
                sides += std::abs(points[v][k]) == s.points[7][k];
                rests += points[v][k] == start[v][k];
            }
            CHECK(sides >= (place[v] == Feature_curves::Place::corner ? 3 : 2));
            CHECK(rests >= sides);
            gone = std::max(gone, distance(points[v], start[v]));
        }
        CHECK(gone > 0.001);
        // Every edge of the box is edges of cells of the domain, end to end: its vertices in their order are joined.
        const Cells_3 cells = cells_of(points);
        const auto inside = cells_inside(surface, cells, points);
        std::set<std::set<Index>> edges;
        for (const auto& f : surface_facets(cells, inside))
            for (std::size_t i = 0; i < 3; ++i) edges.insert({f[i], f[(i + 1) % 3]});
        for (const Polyline_3& curve : sharp->curves()) {
            std::map<double, Index> along;
            for (std::size_t v = 0; v < points.size(); ++v)
                if (const double at = curve.nearest(points[v]); distance(curve.at(at), points[v]) < 1e-9)
                    along[at] = static_cast<Index>(v);
            REQUIRE(along.size() > 2);
            for (auto a = along.begin(), b = std::next(a); b != along.end(); ++a, ++b)
                CHECK(edges.contains({a->second, b->second}));
        }
    }
}

TEST_CASE("graded sizing pulls vertices towards where edges are to be short", "[motion][nodt]") {
    const Points points = body_centred(5, 0.18);
    const Ball_3 ball(0.9);
    const Cells_3 cells = cells_of(points);
    Points target(points.size());
    (void)Nodt_3(ball, Sizing_3(ball, 3), vertices_on_surface(ball, points))
        .step(cells, cells_inside(ball, cells, points), points, target);
    std::size_t counted = 0;
    for (std::size_t v = 0; v < points.size(); ++v) {
        const double r = distance(points[v], {});
        if (r > 0.6 || r < 0.2) continue;
        ++counted;
        CHECK(distance(target[v], {}) > r + 1e-4);
    }
    CHECK(counted > 100);
}

TEST_CASE("natural ODT does not depend on threads", "[motion][nodt]") {
    const Surface_3 surface(box({1, 0.8, 0.6}));
    Points points;
    for (const auto& p : random_points(3000, 7)) points.push_back(surface.contains(p) ? p : surface.project(p));
    const Cells_3 cells = cells_of(points);
    Points one(points.size()), three(points.size());
    const auto a = cells_inside(surface, cells, points, 1), b = cells_inside(surface, cells, points, 3);
    CHECK(a == b);
    const Nodt_step s = Nodt_3(surface, Sizing_3(surface, 1), vertices_on_surface(surface, points), 20.0, 1)
                            .step(cells, a, points, one);
    const Nodt_step t = Nodt_3(surface, Sizing_3(surface, 1), vertices_on_surface(surface, points), 20.0, 3)
                            .step(cells, b, points, three);
    CHECK(one == three);
    CHECK(s.mean_displacement == t.mean_displacement);
    CHECK(s.locked == t.locked);
}

TEST_CASE("targets never coincide, even when they all want to be at one place", "[motion][nodt]") {
    struct Trap final : Domain_3 {  // every projection ends in one point
        [[nodiscard]] bool contains(const Coordinates<3>& p) const override { return distance(p, {}) < 5; }
        using Domain_3::project;
        [[nodiscard]] Coordinates<3> project(const Coordinates<3>&) const override { return {1, 0, 0}; }
        [[nodiscard]] std::optional<Coordinates<3>> crossing(const Coordinates<3>&,
                                                             const Coordinates<3>&) const override {
            return std::nullopt;
        }
        [[nodiscard]] std::vector<Coordinates<3>> surface_sample(std::size_t, std::uint64_t) const override {
            return {};
        }
        [[nodiscard]] Box bounding_box() const override { return {}; }
        [[nodiscard]] double volume() const override { return 1; }
    };
    const Trap trap;
    Points points = round_octahedron(1).points;
    points.push_back({0.1, 0, 0});
    const Cells_3 cells = cells_of(points);
    Points target(points.size());
    std::vector<char> on_surface(points.size(), 1);
    on_surface.back() = 0;
    const Nodt_step step =
        Nodt_3(trap, Sizing_3(trap), on_surface).step(cells, cells_inside(trap, cells, points), points, target);
    CHECK(std::set<Coordinates<3>>(target.begin(), target.end()).size() == points.size());
    CHECK(step.kept >= step.boundary - 1);
}

TEST_CASE("natural ODT refuses arrays that do not fit and angles that lock everything", "[motion][nodt]") {
    const Ball_3 ball(1);
    const Points points = round_octahedron(0).points;
    const Cells_3 cells = cells_of(points);
    Points target(points.size()), small(2);
    const auto inside = cells_inside(ball, cells, points);
    const Nodt_3 nodt(ball, Sizing_3(ball), std::vector<char>(6));
    CHECK_THROWS_AS(nodt.step(cells, inside, points, small), Error);
    CHECK_THROWS_AS(nodt.step(cells, std::vector<char>(1), points, target), Error);
    CHECK_THROWS_AS(Nodt_3(ball, Sizing_3(ball), {}, 71.0), Error);
    CHECK_THROWS_AS(Nodt_3(ball, Sizing_3(ball), {}, 0.0), Error);
    CHECK_THROWS_AS(Nodt_3(ball, Sizing_3(ball), {}, {}, 0), Error);
}
