// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/stability.h>

#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/mesh/evaluate.h>
#include <annulus/predicate/half_width.h>
#include <annulus/published/standard_annulus.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace annulus::inline v1 {

namespace {

/// Two bins per decade, the last one up to a right angle.
std::vector<double> theta_edges() {
    std::vector<double> edges{0};
    for (int k = -8; k <= 0; ++k) edges.push_back(std::pow(10.0, 0.5 * k));
    edges.push_back(0.5 * std::numbers::pi);
    return edges;
}

}  // namespace

template <int d>
Stability_record measure_stability(const Moving_of<d>& dt) {
    const auto x = dt.positions();
    const auto& table = dt.mesh().table();
    Stability_record r;
    r.edges = theta_edges();
    std::vector<std::vector<double>> errors(r.edges.size() - 1);
    for (const Corner_index h : table.facets()) {
        const Facet_certificate<d> f = facet_certificate(table, h, true);
        if (f.kind != Facet_kind::empty_sphere) continue;
        const auto points = tuple<d, d + 2>(f.point, x);
        const double plain = standard_half_width(points),
                     exact = enclose_exactly(points).standard.lower;  // the largest double not above the truth
        ++r.bicells;
        r.above += plain > exact ? 1U : 0U;
        std::array<Coordinates<d>, static_cast<std::size_t>(d) + 2> y;
        for (std::size_t k = 0; k < y.size(); ++k) y[k] = *points[k];
        const auto after = std::upper_bound(r.edges.begin(), r.edges.end() - 1, bicell_theta(y));
        if (exact > 0)
            errors[static_cast<std::size_t>(after - r.edges.begin()) - 1].push_back(std::fabs(plain - exact) / exact);
    }
    for (std::vector<double>& e : errors) {
        r.counts.push_back(e.size());
        std::sort(e.begin(), e.end());
        r.median.push_back(e.empty() ? 0 : e[e.size() / 2]);
        r.most.push_back(e.empty() ? 0 : e.back());
    }
    return r;
}

template Stability_record measure_stability<2>(const Moving_delaunay_2&);
template Stability_record measure_stability<3>(const Moving_delaunay_3&);

}  // namespace annulus::inline v1
