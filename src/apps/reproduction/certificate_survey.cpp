// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/certificate_survey.h>

#include <annulus/degeneracy.h>
#include <annulus/engine/displacement.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/measure/degeneracy.h>
#include <annulus/mesh/certificates.h>
#include <annulus/published/standard_annulus.h>

#include <cmath>

namespace annulus::inline v1 {

namespace {

/// The mean of the finite values, and the share of displacements below them.
struct Tolerances {
    double sum = 0;
    std::uint64_t finite = 0, inside = 0;

    void add(double tolerance, double displacement) {
        if (std::isfinite(tolerance)) {
            sum += tolerance;
            ++finite;
        }
        if (displacement < tolerance || displacement == 0) ++inside;
    }
    [[nodiscard]] double mean() const { return finite > 0 ? sum / static_cast<double>(finite) : 0; }
};

}  // namespace

template <int d>
Moving_of<d> paper_triangulation(std::span<const Coordinates<d>> x) {
    Options options;
    options.strategy = Strategy::paper;
    options.tolerance = Tolerance_kind::paper;
    return Moving_of<d>(x, options);
}

template <int d>
Certificate_survey_record survey(const Moving_of<d>& dt, std::span<const Coordinates<d>> next, double spacing,
                                 Width_record* widths) {
    const auto x = dt.positions();
    const auto n = static_cast<double>(x.size());
    const auto& table = dt.mesh().table();
    Histogram histogram = Histogram::linear(0.0, 1.5, 75);
    double sum = 0, squares = 0, points = 0;
    std::uint64_t bicells = 0;
    for (const Corner_index h : table.facets()) {
        const Facet_certificate<d> f = facet_certificate(table, h, true);
        for (const auto& [v, label] : f.point) points += v != none ? 1 : 0;
        if (f.kind != Facet_kind::empty_sphere) continue;
        const double w = 2 * paper_half_width(f, x) / spacing;
        sum += w;
        squares += w * w;
        ++bicells;
        histogram.add(w);
    }
    Certificate_survey_record r;
    const double m = std::max<double>(1, static_cast<double>(bicells));
    r.width = sum / m;
    r.width_deviation = std::sqrt(std::max(0.0, squares / m - r.width * r.width));
    r.bicells_a_vertex = points / n;
    const std::vector<double> certified = dt.measure().tolerance;
    Tolerances paper, ours;
    for (std::size_t v = 0; v < x.size(); ++v) {
        const double way = next.empty() ? 0 : distance_upper<d>(x[v], next[v]);
        r.displacement += way / spacing / n;
        paper.add(dt.tolerance(dt.vertex(v)), way);
        ours.add(certified[v], way);
    }
    r.paper_tolerance = paper.mean() / spacing;
    r.certified_tolerance = ours.mean() / spacing;
    r.paper_inside = static_cast<double>(paper.inside) / n;
    r.certified_inside = static_cast<double>(ours.inside) / n;
    if (widths) {
        widths->edges.assign(histogram.edges().begin(), histogram.edges().end());
        widths->counts.assign(histogram.counts().begin(), histogram.counts().end());
        widths->total = histogram.total();
    }
    return r;
}

template <int d>
Degeneracy_count_record count_degeneracy(const Moving_of<d>& dt,
                                         const std::function<void(std::span<const Index>)>& unsound) {
    Degeneracy_options<d> options;
    options.unsound = unsound;
    const Degeneracy g = degeneracy(dt.mesh().table(), dt.positions(), options);
    Degeneracy_count_record r;
    r.vertices = g.vertices.total;
    r.bicells = g.bicells.least.total;
    r.certificates = r.bicells + g.cells.least.total + g.ridges.least.total;
    r.non_convex = g.non_convex;
    r.below = g.bicells.least.below;
    for (const Threshold& t : g.thresholds) r.thresholds.push_back(t.relative);
    r.paper_above = g.vertices.paper_above_exact;
    r.paper_unsound = g.vertices.paper_unsound;
    r.unsound_certificates = g.vertices.unsound_certificates;
    for (std::size_t k = 0; k < g.theta.quantiles.size(); ++k) {
        if (Distribution::probabilities[k] == 0.01) r.theta_hundredth = g.theta.quantiles[k];
        if (Distribution::probabilities[k] == 0.5) r.theta_median = g.theta.quantiles[k];
    }
    return r;
}

template Moving_delaunay_2 paper_triangulation<2>(std::span<const Coordinates<2>>);
template Moving_delaunay_3 paper_triangulation<3>(std::span<const Coordinates<3>>);
template Certificate_survey_record survey<2>(const Moving_delaunay_2&, std::span<const Coordinates<2>>, double,
                                             Width_record*);
template Certificate_survey_record survey<3>(const Moving_delaunay_3&, std::span<const Coordinates<3>>, double,
                                             Width_record*);
template Degeneracy_count_record count_degeneracy<2>(const Moving_delaunay_2&,
                                                     const std::function<void(std::span<const Index>)>&);
template Degeneracy_count_record count_degeneracy<3>(const Moving_delaunay_3&,
                                                     const std::function<void(std::span<const Index>)>&);

}  // namespace annulus::inline v1
