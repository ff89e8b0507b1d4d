// SPDX-License-Identifier: GPL-3.0-or-later
// The filtering algorithm and its queue against a second implementation of the paper's text (2.2 to 3.2), which uses
// whole triangulations, long doubles and Cramer's rule for centres.
#include <published/paper_mesh.h>
#include <support/catch.h>

#include <cmath>
#include <limits>
#include <map>
#include <utility>

using namespace annulus;
using namespace annulus::testing;

namespace {

using Real = long double;
using Places = std::vector<Coordinates<2>>;
/// By the points of a bi-cell, half the width of its annulus or slab. A border edge has three points; the points of a
/// hull vertex begin with -1, for infinity.
using Bicells = std::map<std::vector<Index>, Real>;

Real distance(const Coordinates<2>& a, Real x, Real y) { return std::hypot(a[0] - x, a[1] - y); }

/// The width of the annulus; its centre is on the bisectors of a b and of p q (2.3).
Real annulus_width(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& p, const Coordinates<2>& q) {
    const auto square = [](const Coordinates<2>& u) { return Real(u[0]) * u[0] + Real(u[1]) * u[1]; };
    const Real ux = Real(b[0]) - a[0], uy = Real(b[1]) - a[1], wx = Real(q[0]) - p[0], wy = Real(q[1]) - p[1];
    const Real k = (square(b) - square(a)) / 2, m = (square(q) - square(p)) / 2, det = ux * wy - uy * wx;
    const Real x = (k * wy - uy * m) / det, y = (ux * m - k * wx) / det;
    return (distance(p, x, y) + distance(q, x, y)) / 2 - (distance(a, x, y) + distance(b, x, y)) / 2;
}

/// The altitude of c over the line a b (2.2).
Real altitude(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c) {
    const Real ux = Real(b[0]) - a[0], uy = Real(b[1]) - a[1];
    return std::fabs(ux * (Real(c[1]) - a[1]) - uy * (Real(c[0]) - a[0])) / std::hypot(ux, uy);
}

/// The key of a bi-cell is its facet, then its opposite vertices.
Bicells bicells(const std::set<std::vector<Index>>& cells, const Places& f) {
    std::map<std::pair<Index, Index>, std::vector<Index>> opposite;
    for (const auto& c : cells)
        for (std::size_t i = 0; i < 3; ++i) {
            auto edge = std::minmax(c[(i + 1) % 3], c[(i + 2) % 3]);
            opposite[edge].push_back(c[i]);
        }
    Bicells out;
    std::map<Index, std::vector<Index>> border;  // neighbours along the hull
    const auto place = [&](Index v) -> const Coordinates<2>& { return f[static_cast<std::size_t>(v)]; };
    for (auto& [edge, beyond] : opposite) {
        const auto [a, b] = edge;
        std::sort(beyond.begin(), beyond.end());
        if (beyond.size() == 2) {
            out[{a, b, beyond[0], beyond[1]}] =
                annulus_width(place(a), place(b), place(beyond[0]), place(beyond[1])) / 2;
        } else {
            out[{a, b, beyond[0]}] = altitude(place(a), place(b), place(beyond[0])) / 2;
            border[a].push_back(b);
            border[b].push_back(a);
        }
    }
    for (auto& [v, n] : border) {
        std::sort(n.begin(), n.end());
        out[{-1, v, n[0], n[1]}] = altitude(place(n[0]), place(n[1]), place(v)) / 2;
    }
    return out;
}

Places fixed_positions(const Engine<2>& engine) {
    Places f;
    for (Index v = 0; static_cast<std::size_t>(v) < engine.index_bound(); ++v) f.push_back(engine.fixed_position(v));
    return f;
}

/// For each vertex, the least half width of the bi-cells that contain it. Those in `known` count only if they contain
/// `mover`.
std::vector<Real> least(const Bicells& all, const Bicells& known, Index mover, std::size_t n) {
    std::vector<Real> out(n, std::numeric_limits<Real>::infinity());
    for (const auto& [points, half] : all) {
        if (known.contains(points) && std::find(points.begin(), points.end(), mover) == points.end()) continue;
        for (const Index w : points)
            if (w >= 0) out[static_cast<std::size_t>(w)] = std::min(out[static_cast<std::size_t>(w)], half);
    }
    return out;
}

}  // namespace

TEST_CASE("The filtering algorithm and its queue decide as the paper's pseudo-code does", "[published]") {
    int quiet = 0, queued = 0;
    for (const bool improved : {false, true})
        for (const double pace : {0.003, 0.01, 0.03, 0.2}) {
            CAPTURE(improved, pace);
            Random random(7);
            Places x = random_places<2>(40, random);
            const std::size_t n = x.size();
            Paper_mesh<2> dt(x, {.in_place = improved, .flips = improved});
            const auto cells_at = [](const Places& f) {
                return cell_set<2>(Paper_mesh<2>(f, Paper_choice::of(Strategy::relocate)).engine);
            };
            Bicells known = bicells(cells_at(x), x);
            for (std::size_t v = 0; v < n; ++v)
                CHECK(dt.engine.tolerance(static_cast<Index>(v)) ==
                      Approx(double(least(known, {}, -2, n)[v])).epsilon(1e-9));
            for (int step = 0; step < 4; ++step) {
                stir<2>(x, pace, random);
                for (Index v = 0; static_cast<std::size_t>(v) < n; ++v) {
                    const auto i = static_cast<std::size_t>(v);
                    std::vector<double> epsilon;
                    for (Index w = 0; static_cast<std::size_t>(w) < n; ++w) epsilon.push_back(dt.engine.tolerance(w));
                    const bool passes =
                        distance(x[i], dt.engine.fixed_position(v)[0], dt.engine.fixed_position(v)[1]) < epsilon[i];
                    const Move_result r = dt.engine.move(v, x[i]);
                    CHECK((r.moves.within_tolerance == 1) == passes);
                    if (passes) {
                        CHECK(r.statistics.evaluated + r.statistics.requeued == 0);
                        continue;
                    }
                    CHECK(dt.is_at_fixed_position(v));
                    const Places f = fixed_positions(dt.engine);
                    const auto cells = cells_at(f);
                    CHECK(cell_set<2>(dt.engine) == cells);
                    const Bicells all = bicells(cells, f);
                    const std::vector<Real> every = least(all, {}, -2, n), fresh = least(all, known, v, n);
                    for (std::size_t w = 0; w < n; ++w) {
                        const double now = dt.engine.tolerance(static_cast<Index>(w));
                        CHECK(now <= double(every[w]) * (1 + 1e-9));
                        CHECK((dt.is_at_fixed_position(static_cast<Index>(w)) ||
                               dt.engine.displacement(static_cast<Index>(w)) < now * (1 + 1e-9)));
                        const Real before = w == i ? std::numeric_limits<Real>::infinity() : epsilon[w];
                        if (r.statistics.requeued == 0)
                            CHECK(now == Approx(double(std::min(before, fresh[w]))).epsilon(1e-9));
                    }
                    ++(r.statistics.requeued == 0 ? quiet : queued);
                    known = all;
                }
            }
        }
    CHECK(quiet > 50);
    CHECK(queued > 5);
}
