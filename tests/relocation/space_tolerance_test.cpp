// SPDX-License-Identifier: GPL-3.0-or-later
// What a tolerance promises in space: hand-computed values, the paper's counterexample, and moves just inside.
#include <support/session_3.h>

#include <support/arbitrary.h>
#include <support/oracle_3.h>

#include <annulus/motion/cells_3.h>

#include <catch2/catch.hpp>

#include <cmath>

using namespace annulus;
using namespace annulus::testing;
using Kind = Operation_3::Kind;

namespace {

constexpr std::array filters{Strategy::filter, Strategy::filter_each};

/// docs/theory.md 3.
Points_3 spindle(double delta) {
    const double s = std::sqrt(0.75);
    return {{0, 0, 1 - delta}, {0, 0, delta - 1}, {1, 0, 0}, {-0.5, s, 0}, {-0.5, -s, 0}};
}
Points_3 spindle_grown(double by) {
    Points_3 x = spindle(0.01);
    x[0][2] += by;
    x[1][2] -= by;
    for (std::size_t i = 2; i < 5; ++i)
        for (double& c : x[i]) c *= 1 - by;
    return x;
}

Options options_of(Strategy strategy, Tolerance_kind kind) {
    Options o;
    o.strategy = strategy;
    o.tolerance = kind;
    return o;
}

/// The least half width of everything that contains each vertex, by the oracle: cells, bi-cells, ridges.
std::vector<double> true_tolerances(const Moving_delaunay_3& dt) {
    const auto& tr = dt.triangulation();
    std::vector<double> least(dt.index_bound(), std::numeric_limits<double>::infinity());
    const auto x = [&](auto v) { return dt.positions()[static_cast<std::size_t>(v->index())]; };
    const auto lower = [&](auto v, double s) {
        if (!tr.is_infinite(v))
            least[static_cast<std::size_t>(v->index())] = std::min(least[static_cast<std::size_t>(v->index())], s);
    };
    const auto upper_end = [](const Truth_3& truth) { return truth.sign() > 0 ? truth.enclosure().upper() : 0.0; };
    for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c) {
        const double s =
            upper_end(Tetrahedron_truth({x(c->vertex(0)), x(c->vertex(1)), x(c->vertex(2)), x(c->vertex(3))}));
        for (int i = 0; i < 4; ++i) lower(c->vertex(i), s);
    }
    for (auto f = tr.all_facets_begin(); f != tr.all_facets_end(); ++f) {
        const auto [c, i] = *f;
        const auto other = c->neighbor(i);
        const auto p = tr.tds().mirror_vertex(c, i);
        if (tr.is_infinite(c) != tr.is_infinite(other)) continue;
        std::vector<Moving_delaunay_3::Vertex_handle> v{c->vertex((i + 1) & 3), c->vertex((i + 2) & 3),
                                                        c->vertex((i + 3) & 3)};
        if (!tr.is_infinite(c)) {
            Bicell_3 b{x(v[0]), x(v[1]), x(v[2]), x(p), x(c->vertex(i))};
            if (exact_orientation(b.a, b.b, b.c, b.q) < 0) std::swap(b.a, b.b);
            const double s = upper_end(Bicell_3_truth(b, false));
            for (const auto w : v) lower(w, s);
            lower(p, s);
            lower(c->vertex(i), s);
            continue;
        }
        std::erase_if(v, [&](auto w) { return tr.is_infinite(w); });
        Tetrahedron ridge{x(v[0]), x(v[1]), x(c->vertex(i)), x(p)};
        if (exact_orientation(ridge.a, ridge.b, ridge.c, ridge.d) < 0) std::swap(ridge.a, ridge.b);
        const double s = upper_end(Tetrahedron_truth(ridge));
        for (const auto w : {v[0], v[1], c->vertex(i), p}) lower(w, s);
    }
    return least;
}

/// p, at most `share` of r away: in a random direction, or towards or away from `target`.
Coordinates<3> shifted(const Coordinates<3>& p, double r, double share, const Coordinates<3>& target, int kind,
                       Random& random) {
    Coordinates<3> u{between(random, -1, 1), between(random, -1, 1), between(random, -1, 1)};
    if (kind < 2)
        for (std::size_t k = 0; k < 3; ++k) u[k] = kind == 0 ? target[k] - p[k] : p[k] - target[k];
    const double length = std::hypot(u[0], u[1], u[2]);
    if (!(length > 0.0) || !std::isfinite(length) || !std::isfinite(r)) return p;
    Coordinates<3> q = p;
    for (std::size_t k = 0; k < 3; ++k) q[k] += share * r * (u[k] / length);
    return q;
}

/// For every vertex the centre of the sphere of the tightest of its bi-cells: where a move does most harm, or away from it.
Points_3 centres(const Moving_delaunay_3& dt) {
    const auto& tr = dt.triangulation();
    Points_3 target(dt.positions().begin(), dt.positions().end());
    std::vector<double> least(target.size(), std::numeric_limits<double>::infinity());
    if (tr.dimension() != 3) return target;
    for (auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f) {
        const auto c = f->first;
        const int i = f->second;
        if (tr.is_infinite(c) || tr.is_infinite(c->neighbor(i))) continue;
        const auto corner = [&](int k) {
            const auto& at = c->vertex(k)->point();
            return Coordinates<3>{at.x(), at.y(), at.z()};
        };
        double volume = 0;
        Coordinates<3> o = weighted_circumcentre(corner(0), corner(1), corner(2), corner(3), volume);
        for (std::size_t k = 0; k < 3; ++k) o[k] = corner(0)[k] + o[k] / volume;
        if (!std::isfinite(o[0]) || !std::isfinite(o[1]) || !std::isfinite(o[2]))
            continue;  // flat: no centre in doubles
        const auto p = tr.tds().mirror_vertex(c, i);
        const auto distance = [&](const Coordinates<3>& x) {
            return std::hypot(x[0] - o[0], x[1] - o[1], x[2] - o[2]);
        };
        const double room = distance({p->point().x(), p->point().y(), p->point().z()}) - distance(corner(0));
        const auto take = [&](auto v) {
            const auto k = static_cast<std::size_t>(v->index());
            if (!(room < least[k])) return;
            least[k] = room;
            target[k] = o;
        };
        for (int k = 0; k < 4; ++k) take(c->vertex(k));
        take(p);
    }
    return target;
}

}  // namespace

TEST_CASE("The tolerances of a regular tetrahedron and of the spindle are those computed by hand",
          "[tolerance][space]") {
    for (const Strategy strategy : filters) {
        CAPTURE(name_of(strategy));
        // Edge 2 sqrt 2: the distance of opposite edges is 2, the height 2.309; half the width is 1. A ridge is the same four points.
        Moving_delaunay_3 one(Points_3{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                              options_of(strategy, Tolerance_kind::certified));
        for (std::size_t i = 0; i < 4; ++i) {
            CHECK(one.tolerance(one.vertex(i)) <= 1.0);
            CHECK(one.tolerance(one.vertex(i)) > 0.998);
        }
        // Spheres around the origin of radius 0.99 and 1.
        Moving_delaunay_3 five(spindle(0.01), options_of(strategy, Tolerance_kind::certified));
        Moving_delaunay_3 paper(spindle(0.01), options_of(strategy, Tolerance_kind::paper));
        for (std::size_t i = 0; i < 5; ++i) {
            CHECK(five.tolerance(five.vertex(i)) <= 0.005 * (1 + 1e-12));
            CHECK(five.tolerance(five.vertex(i)) > 0.998 * 0.005);
            CHECK(std::fabs(paper.tolerance(paper.vertex(i)) - 0.00748) < 0.00001);
        }
    }
}

TEST_CASE("Inside the paper's tolerances the spindle ends in a triangulation that the audit refuses, certified never",
          "[tolerance][space]") {
    for (const Strategy strategy : filters) {
        CAPTURE(name_of(strategy));
        for (const Tolerance_kind kind : {Tolerance_kind::certified, Tolerance_kind::paper}) {
            Moving_delaunay_3 dt(spindle(0.01), options_of(strategy, kind));
            CHECK(dt.triangulation().number_of_finite_cells() == 3);
            const Move_report report = dt.move_all(spindle_grown(0.007));
            const bool right = dt.audit().delaunay();
            CHECK(right == (kind == Tolerance_kind::certified));
            if (kind == Tolerance_kind::paper) {
                CHECK(report.moves.within_tolerance == 5);
            } else {
                CHECK(dt.triangulation().number_of_finite_cells() == 2);
                CHECK(report.flips == 1);
            }
        }
        // One vertex at a time, and back, for ever right.
        Session_3 session(strategy, spindle(0.01));
        try {
            for (int k = 0; k < 20; ++k)
                for (Index v = 0; v < 5; ++v) {
                    session.apply({Kind::move,
                                   v,
                                   {(k % 2 == 0 ? spindle_grown(0.007) : spindle(0.01))[static_cast<std::size_t>(v)]}});
                    session.check();
                }
        } catch (const Session_3::Fault& fault) {
            FAIL(fault.words);
        }
    }
}

TEST_CASE("A settled tolerance in space is never above what its certificates allow and within 0.2 % of it",
          "[tolerance][space]") {
    for (const Strategy strategy : filters) {
        DYNAMIC_SECTION(name_of(strategy)) {
            REQUIRE(rc::check([=] {
                const Set_3 set = all_sets_3[*rc::gen::inRange<std::size_t>(0, all_sets_3.size())];
                Random random(*seeds());
                const Moving_delaunay_3 dt(point_set(set, 4 + random() % 20, random),
                                           options_of(strategy, Tolerance_kind::certified));
                if (dt.triangulation().dimension() < 3) return;
                const std::vector<double> truth = true_tolerances(dt);
                for (std::size_t i = 0; i < truth.size(); ++i) {
                    const double found = dt.tolerance(dt.vertex(i));
                    // The oracle leaves out the widths of cells that enter a backward partition: they are cells of the vertex's neighbours.
                    RC_ASSERT(found <= truth[i] * (1 + 1e-12));
                }
            }));
        }
    }
}

TEST_CASE("The most harmful moves in space, just inside and just outside the tolerances, leave nothing wrong",
          "[tolerance][space]") {
    for (const Strategy strategy : filters) {
        DYNAMIC_SECTION(name_of(strategy)) {
            REQUIRE(rc::check([=] {
                const Set_3 set = all_sets_3[*rc::gen::inRange<std::size_t>(0, all_sets_3.size())];
                const auto seed = *seeds();
                Random random(seed);
                const std::size_t n = 4 + random() % 12;
                Points_3 x = point_set(set, n, random);
                Program_3 program{strategy, x, {}};
                try {
                    Session_3 session(strategy, x);
                    for (int step = 0; step < 8; ++step) {
                        const Points_3 target = centres(session.dt());
                        const double share = std::array{0.9999, 0.9999, 1.002, 1.3, 3.0}[random() % 5];
                        const int away = static_cast<int>(random() % 3);
                        Points_3 y = x;
                        for (std::size_t i = 0; i < n; ++i) {
                            if (random() % 4 == 0) continue;
                            const auto v = session.dt().vertex(i);
                            const auto f = session.dt().fixed_position(v);
                            y[i] = shifted({f.x(), f.y(), f.z()}, session.dt().tolerance(v), share, target[i], away,
                                           random);
                        }
                        Points_3 sorted = y;
                        std::sort(sorted.begin(), sorted.end());
                        if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) continue;
                        x = y;
                        program.operations.push_back({Kind::move_all, none, x});
                        session.apply(program.operations.back());
                        session.check();
                    }
                } catch (const Session_3::Fault& fault) {
                    RC_FAIL(fault.words + "\n" + as_code(program));
                }
            }));
        }
    }
}

TEST_CASE("Moves of 0.9999 tolerances in space evaluate nothing and keep the triangulation", "[tolerance][space]") {
    for (const Strategy strategy : filters) {
        CAPTURE(name_of(strategy));
        Random random(23);
        const Points_3 home = point_set(Set_3::uniform, 300, random);
        for (int kind = 0; kind < 3; ++kind) {
            Moving_delaunay_3 dt(home, options_of(strategy, Tolerance_kind::certified));
            const Points_3 target = centres(dt);
            const auto before = cells_of(dt.triangulation());
            Points_3 x = home;
            for (std::size_t i = 0; i < x.size(); ++i)
                x[i] = shifted(x[i], dt.tolerance(dt.vertex(i)), 0.9999, target[i], kind, random);
            const Move_report report = dt.move_all(x);
            CHECK(report.evaluated == 0);
            CHECK(report.moves.within_tolerance == x.size());
            CHECK(cells_of(dt.triangulation()) == before);
            CHECK(dt.audit().delaunay());
        }
    }
}
