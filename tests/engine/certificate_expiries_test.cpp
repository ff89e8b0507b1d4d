// SPDX-License-Identifier: GPL-3.0-or-later
// The storage of certificates' expiries: every expiry has its own place, and is found from every side.
#include <annulus/engine/certificate_expiries.h>
#include <annulus/moving_mesh.h>

#include <annulus/kernel/delaunay_mesh.h>
#include <support/catch.h>
#include <support/generators.h>
#include <support/point_sets_3.h>

#include <map>
#include <type_traits>
#include <utility>

using namespace annulus;
using namespace annulus::testing;

namespace {

template <int d>
auto some_points(Random& random) {
    std::vector<Coordinates<d>> x(60);
    for (auto& p : x)
        for (double& c : p) c = unit(random);
    return x;
}

}  // namespace

TEMPLATE_TEST_CASE_SIG("Every certificate has an expiry for each of its points, in a place of its own, dimension",
                       "[expiry]", ((int d), d), 2, 3) {
    Random random(41);
    Delaunay_mesh<d> e;
    e.build(some_points<d>(random));
    const Corner_table<d>& t = e.table();
    Certificate_expiries<d> expiries;
    expiries.resize(t.cell_bound());
    // A number for every point of every certificate.
    std::map<std::pair<Certificate_id, Index>, Expiry> truth;
    double number = 1.0;
    const auto next = [&number] { return Expiry::lower(number += 1.0); };
    for (const Corner_index f : t.facets()) {
        if (facet_kind(t, f) != Facet_kind::empty_sphere) continue;
        const Facet_sites<d> point = bicell_sites(t, f);
        for (std::size_t k = 0; k < point.size(); ++k) {
            const Expiry number_of_point = next();
            expiries.of_facet(f, t.twin(f), k) = number_of_point;
            truth[{id_of_facet(f), point[k].vertex}] = number_of_point;
        }
    }
    for (const Cell_index c : t.finite_cells())
        for (int i = 0; i <= d; ++i) {
            const Expiry number_of_corner = next();
            expiries.of_cell(t.corner(c, i)) = number_of_corner;
            truth[{id_of_cell(c), t.vertex(t.corner(c, i))}] = number_of_corner;
        }
    // A star walk around every vertex finds these and no others.
    std::size_t found = 0;
    Corner_index own;
    for (Index v = 0; v < t.vertex_bound(); ++v)
        for_each_certificate(
            t, v,
            [&](Corner_index h) {
                own = h;
                if (t.is_infinite(t.cell_of(h))) return;
                REQUIRE(expiries.of_cell(h) == truth.at({id_of_cell(t.cell_of(h)), v}));
                ++found;
            },
            [&](Corner_index h) {
                const Corner_index f = t.facet(h);
                if (facet_kind(t, f) != Facet_kind::empty_sphere) return;
                REQUIRE(expiries.of_facet(t, f, v) == truth.at({id_of_facet(f), v}));
                REQUIRE(expiries.of_facet(t, h, own) == truth.at({id_of_facet(f), v}));
                if (t.vertex(h) == v) REQUIRE(expiries.of_opposite(h) == truth.at({id_of_facet(f), v}));
                ++found;
            });
    CHECK(found == truth.size());
    // A vertex that is not a point of a certificate has no expiry in it.
    for (const Corner_index f : t.facets()) {
        if (facet_kind(t, f) != Facet_kind::empty_sphere) continue;
        for (Index v = 0; v < t.vertex_bound(); ++v)
            if (!truth.contains({id_of_facet(f), v})) REQUIRE(expiries.of_facet(t, f, v) == Expiry::never());
    }
}
