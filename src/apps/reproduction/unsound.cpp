// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/counterexample.h>
#include <apps/report/svg_triangulation.h>
#include <apps/reproduction/claim_words.h>
#include <apps/reproduction/figures.h>

#include <cmath>

// Cases in which the paper's tolerance is too large: five points, and every run.
namespace annulus::inline v1 {

namespace {

/// The five points from the front and a little from above: a and b on the axis, p, q and r around them.
Panel oblique_view(double height, double radius, bool axis, std::string heading) {
    const auto seen = [](double x, double y, double z) { return Coordinates<2>{x + 0.35 * y, z + 0.25 * y}; };
    const double half = 0.5 * radius, side = 0.5 * std::sqrt(3.0) * radius;
    Picture p;
    p.points = {seen(0, 0, height), seen(0, 0, -height), seen(radius, 0, 0), seen(-half, side, 0),
                seen(-half, -side, 0)};
    p.edges = {{0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}, {2, 3}, {2, 4}, {3, 4}};
    if (axis) p.edges.push_back({0, 1});
    Window window;
    window.half_side = 1.15;
    return {std::move(heading), svg_triangulation(p, window), "", {}};
}

Csv_table counts_table(const Reproduction& r) {
    Csv_table t{{"run", "before_step", "vertices", "paper_above_exact", "paper_unsound", "unsound_certificates",
                 "attacked", "broken", "accepted", "audited", "refuted"},
                {}};
    for (const auto& [name, benchmark] : r.benchmarks)
        for (const auto& g : benchmark.degeneracies) {
            const auto a = std::find_if(benchmark.adversaries.begin(), benchmark.adversaries.end(),
                                        [&](const auto& x) { return x.step == g.step; });
            std::vector<Csv_cell> row{name, g.step, g.vertices, g.paper_above, g.paper_unsound, g.unsound_certificates};
            if (a == benchmark.adversaries.end()) row.resize(t.header.size());
            else row.insert(row.end(), {a->certificates, a->broken, a->accepted, a->audited, a->refuted});
            t.rows.push_back(std::move(row));
        }
    return t;
}

Plot share_plot(const Reproduction& r, const char* title, std::uint64_t Degeneracy_count_record::*count) {
    Plot plot{title, {"iteration", Scale::log10, {}, {}, true}, {"vertices (%)", Scale::linear, 0., {}, false}, {}};
    for (const Benchmark_record* benchmark : meshes(r)) {
        Series s{benchmark->name.substr(5), {}, {}};
        for (const auto& g : benchmark->degeneracies) {
            s.x.push_back(static_cast<double>(g.step));
            s.y.push_back(100 * static_cast<double>(g.*count) /
                          static_cast<double>(std::max<std::uint64_t>(g.vertices, 1)));
        }
        if (!s.x.empty()) plot.series.push_back(std::move(s));
    }
    return plot;
}

/// Median relative error of plain double by theta, of all runs of one dimension at the start.
Plot stability_plot(const Reproduction& r, int dimension) {
    Plot plot{dimension == 2 ? "Rounding, plane" : "Rounding, space",
              {"theta (radians)", Scale::log10, {}, {}, true},
              {"median relative error of half widths", Scale::log10, {}, {}, false},
              {}};
    for (const Benchmark_record* benchmark : dimension == 2 ? lloyds(r) : meshes(r)) {
        if (benchmark->stabilities.empty()) continue;
        const Stability_record& e = benchmark->stabilities.front();
        Series s{benchmark->name.substr(benchmark->name.find('-') + 1), {}, {}};
        for (std::size_t k = 1; k < e.counts.size(); ++k) {
            if (e.counts[k] < 20 || !(e.median[k] > 0)) continue;
            s.x.push_back(std::sqrt(e.edges[k] * e.edges[k + 1]));
            s.y.push_back(e.median[k]);
        }
        if (!s.x.empty()) plot.series.push_back(std::move(s));
    }
    return plot;
}

}  // namespace

Page_content unsound_page(const Reproduction& r) {
    Page_content page{"unsound", "Where the paper's tolerance is too large",
                      "In space the standard annulus, through the facet and through the two opposite vertices, is the "
                      "thinnest one only where the segment between these meets the facet. Where it does not, the "
                      "tolerance that the paper takes from it may be too large."};
    const Counterexample c = counterexample(0.01);
    std::vector<Panel> panels;
    panels.push_back(oblique_view(1 - 10 * c.delta, 1, true, "Before: three cells around the axis"));
    panels.back().caption =
        "Two points on the axis and three on the unit circle around it. The two are nearer to the centre by 0.1 for "
        "the eye, by 0.01 in the numbers: the paper's tolerance is " +
        readable(c.paper) + " for all five, the exact one " + readable(c.exact) + ".";
    panels.push_back(oblique_view(1 + 5 * c.delta, 0.9, false, "After: two cells, above and below the three"));
    panels.back().caption =
        "The two went outward and the three inward, by " + readable(c.move) +
        " each in the numbers, less than the paper's tolerance: it accepts the move. The three cells are " +
        std::string(c.three_after ? "Delaunay still" : "not Delaunay any more") + ", the two are" +
        std::string(c.two_after ? "" : " not") + ", decided exactly.";
    page.sections.emplace_back("Five points", std::move(panels));
    panels.clear();
    append_plot(page, panels, share_plot(r, "Tolerance above the truth", &Degeneracy_count_record::paper_above),
                "unsound.above.csv",
                "Vertices whose tolerance is above the distance to degeneracy of a certificate that they are in. "
                "Counted exactly.");
    append_plot(page, panels, share_plot(r, "Tolerance unsound", &Degeneracy_count_record::paper_unsound),
                "unsound.shares.csv",
                "Vertices of certificates all of whose points have too large a tolerance: they may go where it fails "
                "and all stay within.");
    if (!panels.empty()) page.sections.emplace_back("Along the runs", std::move(panels));
    panels.clear();
    for (const int dimension : {2, 3})
        append_plot(page, panels, stability_plot(r, dimension),
                    dimension == 2 ? "unsound.rounding-plane.csv" : "unsound.rounding-space.csv",
                    "At the start; bins of theta with twenty bi-cells at least.");
    if (!panels.empty())
        page.sections.emplace_back("Plain double against integers (the paper's figure 4)", std::move(panels));
    page.tables.emplace_back("unsound.csv", counts_table(r));
    page.notes.push_back(
        "The adversary takes each unsound certificate (2,000 at most, spread evenly) of a run at the steps of the "
        "table, with all vertices at their fixed positions, and moves its points along the radii of one of the ten "
        "annuli through five of them, or across one of the seven slabs through four, by a millionth less than the "
        "paper's tolerance. \"Broken\": the certificate then fails, in integers. \"Accepted\": the paper's algorithm "
        "lets each of these moves pass as within tolerance. \"Refuted\": the exact audit of the whole triangulation, "
        "for the first twenty, says that it is not Delaunay.");
    for (const Benchmark_record* benchmark : meshes(r))
        for (const Attack_record& a : benchmark->adversaries)
            if (!a.example.empty()) {
                page.notes.push_back(benchmark->title + ", before step " + grouped(a.step) +
                                     ", the first one: " + a.example);
                break;
            }
    return page;
}

}  // namespace annulus::inline v1
