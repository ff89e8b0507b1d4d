// SPDX-License-Identifier: GPL-3.0-or-later
// Targets of natural ODT against its definition, in long double.
#include "nodt_cases.h"
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
        const Mesh_cells<3> cells = cells_of(points);
        Points target(points.size());
        const std::vector<char> on_surface = vertices_on_surface(domain, points);
        const Nodt_step step = Nodt_3(domain, Sizing_3(domain), on_surface)
                                   .step(cells, cells_inside(domain, cells, points), points, target);
        const Points expected = targets_by_definition(domain, on_surface, points, cells.vertices);
        for (std::size_t v = 0; v < points.size(); ++v) CHECK(distance(target[v], expected[v]) < 1e-9);
        CHECK(step.vertices <= points.size());
        CHECK(step.boundary > 50);
        CHECK(step.vertices > step.boundary + 100);
        CHECK(step.max_displacement > step.mean_displacement);
    }
}
