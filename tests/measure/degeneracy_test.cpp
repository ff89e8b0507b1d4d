// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/degeneracy.h>
#include <annulus/moving_delaunay_2.h>
#include <annulus/moving_delaunay_3.h>
#include <annulus/moving_mesh.h>
#include <support/catch.h>
#include <support/oracle_3.h>
#include <support/point_sets_3.h>
#include <support/repeats.h>

#include <cmath>
#include <numbers>
#include <set>

using namespace annulus;
using namespace annulus::testing;

namespace {

Degeneracy of(const std::vector<Coordinates<2>>& x) {
    Delaunay_mesh<2> e;
    e.build(x);
    REQUIRE(e.dimension() == 2);
    return degeneracy(e.table(), x);
}
Degeneracy of(const std::vector<Coordinates<3>>& x) {
    Delaunay_mesh<3> e;
    e.build(x);
    REQUIRE(e.dimension() == 3);
    return degeneracy(e.table(), x);
}

using Below = std::vector<std::uint64_t>;

}  // namespace

TEMPLATE_TEST_CASE_SIG("Degeneracy of a mesh is that of its cells, dimension", "[measure][degeneracy]", ((int d), d), 2,
                       3) {
    std::vector<Coordinates<d>> x;
    for (std::size_t i = 0; i < 60; ++i) {
        auto& p = x.emplace_back();
        for (std::size_t c = 0; c < d; ++c) p[c] = double((i * (7 + 4 * c * c) + i / 5) % 13);
        p[0] += double(i) / 64;
    }
    const Moving_mesh<d> mesh{std::span<const Coordinates<d>>(x)};
    const Degeneracy found = degeneracy(mesh);
    const Degeneracy expected = degeneracy(mesh.mesh().table(), mesh.points());
    CHECK(found.dimension == d);
    CHECK(found.bicells.least.total > 0);
    CHECK(found.bicells.least.total == expected.bicells.least.total);
    CHECK(found.bicells.least.below == expected.bicells.least.below);
    CHECK(found.vertices.total == x.size());

    const std::vector<Coordinates<d>> line{{0, 0}, {1, 1}, {2, 2}};
    CHECK_THROWS_AS(degeneracy(Moving_mesh<d>(std::span<const Coordinates<d>>(line))), Error);
}

TEST_CASE("a grid: every diagonal is cocircular, every straight hull vertex collinear", "[measure][degeneracy]") {
    const std::size_t n = 7;
    std::vector<Coordinates<2>> x;
    for (std::size_t i = 0; i < n * n; ++i) x.push_back({double(i % n), double(i / n)});
    const Degeneracy d = of(x);
    const std::uint64_t squares = (n - 1) * (n - 1);
    CHECK(d.spacing == Approx(std::sqrt(double(squares) / double(n * n))).epsilon(1e-14));
    CHECK(d.resolution == 0x1p-50);  // 6 is between 4 and 8
    CHECK(d.cells.least.total == 2 * squares);
    CHECK(d.cells.least.zero == 0);
    CHECK(d.cells.least.below == Below(5, 0));
    CHECK(d.bicells.least.total == squares + 2 * (n - 1) * (n - 2));
    CHECK(d.bicells.least.zero == squares);
    CHECK(d.bicells.least.below == Below(5, squares));
    CHECK(d.bicells.decided_exactly == squares);
    CHECK(d.ridges.least.total == 4 * (n - 1));
    CHECK(d.ridges.least.zero == 4 * (n - 2));
    CHECK(d.vertices.total == n * n);
    CHECK(d.vertices.zero == n * n);
    CHECK(d.vertices.paper_above_exact == 0);
    CHECK(d.vertices.paper_unsound == 0);
    CHECK(d.non_convex == 0);
    CHECK(d.bicells.arithmetic.total() == d.bicells.least.total);
    CHECK(d.bicells.arithmetic.exact >= squares);
    // Two triangles that share a side of the grid: the annulus through (0, 0), (1, 0) and (0, 1), (1, -1) or (0, 1),
    // (0, -1).
    CHECK(d.bicells.least.width.quantiles.back() > 0.1);
    CHECK(d.theta.histogram.total() == d.bicells.least.total);
}

TEST_CASE("three collinear points in a bi-cell are flat, not reflex", "[measure][degeneracy]") {
    // The facet (0, 0) (0, 2) between (-3, 0) and (3, 0), and a reflex one where the facet is moved up.
    CHECK(of(std::vector<Coordinates<2>>{{0, 0}, {0, 2}, {-3, 0}, {3, 0}}).flat == 1);
    CHECK(of(std::vector<Coordinates<2>>{{0, 0}, {0, 2}, {-3, 0}, {3, 0}}).non_convex == 0);
    const Degeneracy d = of(std::vector<Coordinates<2>>{{0, 0.5}, {0, 2}, {-3, 0}, {3, 0}});
    CHECK(d.flat == 0);
    CHECK(d.bicells.least.total == 3);
    CHECK(d.non_convex == 3);
}

TEST_CASE("a cube: its bi-cells are cospherical, its faces' diagonals coplanar", "[measure][degeneracy]") {
    std::vector<Coordinates<3>> x;
    for (int i = 0; i < 8; ++i) x.push_back({double(i & 1), double(i >> 1 & 1), double(i >> 2)});
    const Degeneracy d = of(x);
    CHECK(d.spacing == Approx(0.5).epsilon(1e-14));
    CHECK(d.bicells.least.zero == d.bicells.least.total);
    CHECK(d.standard.zero == d.standard.total);
    CHECK(d.ridges.least.total == 18);  // twelve triangles
    CHECK(d.ridges.least.zero == 6);
    CHECK(d.cells.least.zero == 0);
    CHECK(d.vertices.zero == 8);
    CHECK(d.vertices.paper_unsound == 0);
}

TEST_CASE("the spindle: the paper's tolerance is unsound at all five points", "[measure][degeneracy]") {
    const double h = std::sqrt(0.75);
    const Degeneracy d =
        of(std::vector<Coordinates<3>>{{0, 0, 0.99}, {0, 0, -0.99}, {1, 0, 0}, {-0.5, h, 0}, {-0.5, -h, 0}});
    CHECK(d.bicells.least.total == 3);
    CHECK(d.cells.least.total == 3);
    CHECK(d.ridges.least.total == 9);
    // docs/theory.md 3: half widths 0.005 and 0.00748.
    CHECK(d.bicells.least.width.quantiles.front() * d.spacing == Approx(0.01).epsilon(1e-9));
    CHECK(d.standard.width.quantiles.front() * d.spacing == Approx(2 * 0.00748).epsilon(1e-3));
    CHECK(d.non_convex == 3);
    CHECK(d.vertices.paper_unsound == 5);
    CHECK(d.vertices.paper_above_exact == 5);
    CHECK(d.vertices.unsound_certificates == 3);
}

TEST_CASE("a regular tetrahedron and its centre", "[measure][degeneracy]") {
    const Degeneracy d = of(std::vector<Coordinates<3>>{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}, {0, 0, 0}});
    CHECK(d.spacing == Approx(std::cbrt(8.0 / 15)).epsilon(1e-14));
    CHECK(d.bicells.least.total == 6);
    CHECK(d.non_convex == 6);  // reflex at the centre
    CHECK(d.flat == 0);
    CHECK(d.theta.quantiles.front() == Approx(std::numbers::pi / 2));
    CHECK(d.cells.least.total == 4);
    // The altitude of a cell over its outer facet is 1 / sqrt(3); of the others, and between opposite edges, it is
    // more.
    CHECK(d.cells.least.width.quantiles.front() * d.spacing == Approx(1 / std::sqrt(3)).epsilon(1e-9));
    CHECK(d.ridges.least.total == 6);
    CHECK(d.ridges.least.width.quantiles.front() == d.ridges.least.width.quantiles.back());
    CHECK(d.ridges.least.width.quantiles.front() * d.spacing == Approx(2).epsilon(1e-9));  // between opposite edges
    CHECK(d.bicells.least.zero + d.cells.least.zero + d.ridges.least.zero + d.vertices.zero == 0);
    CHECK(d.bicells.arithmetic.total() == 6);
}

TEST_CASE("counts of nearly degenerate points are those of real numbers", "[measure][degeneracy]") {
    // A square with one corner moved by e: half the width is e / (4 sqrt 2), to first order.
    for (const int k : {-4, -12, -22, -32, -42, -51}) {
        const double e = std::ldexp(1.0, k);
        const Degeneracy d = of(std::vector<Coordinates<2>>{{0, 0}, {1, 0}, {1, 1}, {0, 1 + e}});
        CHECK(d.bicells.least.total == 1);
        CHECK(d.bicells.least.zero == 0);
        const double width = e / std::sqrt(8);
        Below expected;
        for (const Threshold& t : d.thresholds) expected.push_back(width < t.width ? 1 : 0);
        CHECK(d.bicells.least.below == expected);
        CHECK(d.bicells.least.width.quantiles[0] * d.spacing == Approx(width).epsilon(0.1));
    }
}

TEST_CASE("counts do not depend on the unit of length if it is a power of two", "[measure][degeneracy]") {
    Random random(7);
    const auto json = [](const Degeneracy& d) {
        std::vector<double> all;
        for (const auto* c : {&d.bicells.least, &d.standard, &d.cells.least, &d.ridges.least}) {
            all.insert(all.end(), {double(c->total), double(c->zero)});
            all.insert(all.end(), c->below.begin(), c->below.end());
        }
        const Vertex_counts& v = d.vertices;
        all.insert(all.end(), v.below.begin(), v.below.end());
        all.insert(all.end(), {double(v.zero), double(v.paper_above_exact), double(v.paper_unsound),
                               double(d.non_convex), double(d.flat)});
        return all;
    };
    for (const Set_3 set : {Set_3::uniform, Set_3::lattice, Set_3::slivers, Set_3::near_sphere}) {
        const Points_3 x = point_set(set, 60, random);
        const Degeneracy here = of(x);
        for (const int k : {-300, -3, 20, 400}) {
            Points_3 y = x;
            for (auto& p : y)
                for (double& c : p) c = std::ldexp(c, k);
            const Degeneracy there = of(y);
            CHECK(there.spacing ==
                  Approx(std::ldexp(here.spacing, k)).epsilon(1e-13));  // cells may come in another order
            CHECK(json(there) == json(here));
        }
    }
}

// ---- Independent counts, in rational numbers, from CGAL's object alone --------------------------------------------

namespace {

using Tr = Moving_delaunay_3::Triangulation;

struct Bounds {
    double lower = 0, upper = 0;
};
struct Item {
    std::vector<Index> points;
    Bounds bounds;  ///< of the half width
    Truth_3 truth{};
};

Point_3 point(const Tr::Vertex_handle& v) { return {v->point().x(), v->point().y(), v->point().z()}; }

Item item(std::vector<Index> points, const Truth_3& t) {
    if (t.sign() == 0) return {std::move(points), {}, t};
    const Enclosure e = t.enclosure();
    return {std::move(points), {e.lower(), e.upper()}, t};
}

/// Half the distance between the plane through o with directions u and v, and p.
Bounds half_distance(const Point_3& o, const std::array<Point_3, 2>& u, const std::array<Point_3, 2>& v,
                     const Point_3& p) {
    const auto minus = [](const Point_3& a, const Point_3& b) {
        return std::array<mpq_class, 3>{mpq_class(a[0]) - mpq_class(b[0]), mpq_class(a[1]) - mpq_class(b[1]),
                                        mpq_class(a[2]) - mpq_class(b[2])};
    };
    const auto s = minus(u[1], u[0]), t = minus(v[1], v[0]), w = minus(p, o);
    mpq_class height = 0, norm = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class n = s[(k + 1) % 3] * t[(k + 2) % 3] - s[(k + 2) % 3] * t[(k + 1) % 3];
        height += n * w[k];
        norm += n * n;
    }
    if (height == 0) return {};
    const mpf_class h = sqrt(mpf_class(mpq_class(height * height / norm / 4), 400));
    return {h.get_d(), std::nextafter(h.get_d(), HUGE_VAL)};  // get_d truncates
}

struct Independent {
    std::vector<Item> bicells, standard, cells, ridges, slabs;  // ridges here with the certificate's width
    std::vector<Item> ridge_slabs;
    std::uint64_t non_convex = 0, flat = 0;
};

Independent count_independently(const Tr& tr) {
    Independent out;
    const auto inf = tr.infinite_vertex();
    for (auto c = tr.finite_cells_begin(); c != tr.finite_cells_end(); ++c) {
        const Tetrahedron t{point(c->vertex(0)), point(c->vertex(1)), point(c->vertex(2)), point(c->vertex(3))};
        out.cells.push_back(
            item({c->vertex(0)->index(), c->vertex(1)->index(), c->vertex(2)->index(), c->vertex(3)->index()},
                 Tetrahedron_truth(t)));
    }
    for (auto f = tr.all_facets_begin(); f != tr.all_facets_end(); ++f) {
        auto c = f->first;
        int i = f->second;
        auto q = c->vertex(i), p = tr.mirror_vertex(c, i);
        std::array<Tr::Vertex_handle, 3> v{c->vertex((i + 1) & 3), c->vertex((i + 2) & 3), c->vertex((i + 3) & 3)};
        const auto infinite_one = std::find(v.begin(), v.end(), inf);
        if (infinite_one != v.end()) {  // a hull edge
            std::swap(*infinite_one, v[2]);
            Tetrahedron t{point(v[0]), point(v[1]), point(p), point(q)};
            if (exact_orientation(t.a, t.b, t.c, t.d) < 0) std::swap(t.a, t.b);
            const std::vector<Index> points{v[0]->index(), v[1]->index(), p->index(), q->index()};
            out.ridges.push_back(item(points, Tetrahedron_truth(t)));
            out.ridge_slabs.push_back({points, half_distance(t.a, {t.a, t.b}, {t.c, t.d}, t.c)});
            continue;
        }
        if (q == inf) std::swap(p, q);
        if (p == inf) {
            out.slabs.push_back(
                {{v[0]->index(), v[1]->index(), v[2]->index(), q->index()},
                 half_distance(point(v[0]), {point(v[0]), point(v[1])}, {point(v[0]), point(v[2])}, point(q))});
            continue;
        }
        Bicell_3 b{point(v[0]), point(v[1]), point(v[2]), point(p), point(q)};
        if (exact_orientation(b.a, b.b, b.c, b.q) < 0) std::swap(b.a, b.b);
        const std::vector<Index> points{v[0]->index(), v[1]->index(), v[2]->index(), p->index(), q->index()};
        out.bicells.push_back(item(points, Bicell_3_truth(b, false)));
        out.standard.push_back(item(points, Annulus_truth(b, 0)));
        const std::array<int, 3> side{exact_orientation(b.p, b.q, b.a, b.b), exact_orientation(b.p, b.q, b.b, b.c),
                                      exact_orientation(b.p, b.q, b.c, b.a)};
        const auto [least, most] = std::minmax_element(side.begin(), side.end());
        if (*least < 0 && *most > 0) ++out.non_convex;
        else out.flat += std::count(side.begin(), side.end(), 0) > 0 ? 1U : 0U;
    }
    return out;
}

void check_counts(const Width_counts& c, const std::vector<Item>& items, const std::vector<Threshold>& thresholds) {
    const auto count = [&](const auto& is) { return std::uint64_t(std::count_if(items.begin(), items.end(), is)); };
    CHECK(c.total == items.size());
    CHECK(c.zero == count([](const Item& i) { return i.truth.sign() == 0; }));
    for (std::size_t k = 0; k < thresholds.size(); ++k) {
        const double y = thresholds[k].width / 2;
        CHECK(c.below[k] == count([y](const Item& i) { return i.truth.sign() == 0 || !i.truth.is_at_least(y); }));
    }
}

}  // namespace

TEST_CASE("counts in space are those of rational arithmetic", "[measure][degeneracy][deep]") {
    Random random(11);
    std::uint64_t unsound = 0;
    for (const Set_3 set : all_sets_3) {
        const Points_3 x = point_set(set, 10 + static_cast<std::size_t>(repeats(30)), random);
        Delaunay_mesh<3> e;
        e.build(x);
        if (e.dimension() < 3) continue;
        INFO(name_of(set));
        const Degeneracy d = degeneracy(e.table(), x);
        const Independent i = count_independently(Cgal_view_3<No_info>(e, x).update(x));
        check_counts(d.bicells.least, i.bicells, d.thresholds);
        check_counts(d.standard, i.standard, d.thresholds);
        check_counts(d.cells.least, i.cells, d.thresholds);
        check_counts(d.ridges.least, i.ridges, d.thresholds);
        CHECK(d.non_convex == i.non_convex);
        CHECK(d.flat == i.flat);

        // The paper's tolerances: certainly greater, and perhaps.
        std::vector<Bounds> paper(x.size(), {HUGE_VAL, HUGE_VAL});
        for (const auto* items : {&i.standard, &i.slabs, &i.ridge_slabs})
            for (const Item& s : *items)
                for (const Index v : s.points) {
                    Bounds& b = paper[static_cast<std::size_t>(v)];
                    b = {std::min(b.lower, s.bounds.lower), std::min(b.upper, s.bounds.upper)};
                }
        std::set<Index> above, maybe_above, all_above, maybe_all_above;
        for (const auto* items : {&i.bicells, &i.cells, &i.ridges})
            for (std::size_t k = 0; k < items->size(); ++k) {
                const Item& c = (*items)[k];
                const bool own = items == &i.bicells && i.standard[k].bounds.lower <= c.bounds.upper;
                bool all = true, maybe_all = !own;
                for (const Index v : c.points) {
                    const Bounds& b = paper[static_cast<std::size_t>(v)];
                    if (b.lower > c.bounds.upper) above.insert(v);
                    else all = false;
                    if (!own && b.upper > c.bounds.lower) maybe_above.insert(v);
                    else maybe_all = false;
                }
                if (all) all_above.insert(c.points.begin(), c.points.end());
                if (maybe_all) maybe_all_above.insert(c.points.begin(), c.points.end());
            }
        CHECK(d.vertices.paper_above_exact >= above.size());
        CHECK(d.vertices.paper_above_exact <= maybe_above.size());
        CHECK(d.vertices.paper_unsound >= all_above.size());
        CHECK(d.vertices.paper_unsound <= maybe_all_above.size());
        unsound += d.vertices.paper_unsound;
    }
    CHECK(unsound > 0);
}

TEST_CASE("in the plane the paper's tolerance is sound", "[measure][degeneracy]") {
    Random random(13);
    for (const Family family : all_families) {
        const Points x = point_set(family, 120, random);
        Delaunay_mesh<2> e;
        e.build(x);
        if (e.dimension() < 2) continue;
        INFO(name_of(family));
        const Degeneracy d = degeneracy(e.table(), x);
        CHECK(d.vertices.paper_unsound == 0);
        CHECK(d.vertices.unsound_certificates == 0);
        CHECK(d.vertices.total == x.size());
    }
}
