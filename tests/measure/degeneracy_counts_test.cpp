// SPDX-License-Identifier: GPL-3.0-or-later
// Counts of degenerate certificates against rational numbers, from CGAL's object alone.
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
