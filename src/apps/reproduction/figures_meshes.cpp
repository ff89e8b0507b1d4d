// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_words.h>
#include <apps/reproduction/figures.h>

// Figures 8 to 10, slivers and locks: the quality of meshes.
namespace annulus::inline v1 {

namespace {

std::string body_of(const Benchmark_record& benchmark) {
    const std::string name = benchmark.name.substr(benchmark.name.find('-') + 1);
    return name == "liver" ? "liver (in place of the heart)" : name;
}

void append_pictures(const Benchmark_record& benchmark, const std::vector<std::uint64_t>& steps,
                     std::vector<Panel>& panels, const std::string& csv) {
    for (const Picture_record& p : benchmark.pictures)
        if (std::find(steps.begin(), steps.end(), p.step) != steps.end())
            panels.push_back({body_of(benchmark) + ", " + caption_of(p), p.svg, "",
                              p.step == steps.back() ? std::vector{csv} : std::vector<std::string>{}, true});
}

Series angles(const Quality_record& q) {
    Series s{q.step == 0 ? "initially" : "iteration " + grouped(q.step), {0}, {}, true};
    double sum = 0;
    for (const std::uint64_t n : q.dihedral) sum += static_cast<double>(n);
    for (const std::uint64_t n : q.dihedral) {
        s.x.push_back(5 * static_cast<double>(s.x.size()));
        s.y.push_back(sum > 0 ? 100 * static_cast<double>(n) / sum : 0);
    }
    return s;
}

Csv_table quality_table(const Benchmark_record& benchmark) {
    Csv_table t{{"iteration", "vertices", "locked", "cells", "slivers", "dihedral_min", "dihedral_max"}, {}};
    for (const Quality_record& q : benchmark.qualities)
        t.rows.push_back({q.step, q.vertices, q.locked, q.cells, q.slivers, q.dihedral_min, q.dihedral_max});
    return t;
}

Plot over_iterations(std::string title, std::string label, const std::vector<const Benchmark_record*>& benchmarks,
                     double (*value)(const Quality_record&)) {
    Plot plot{std::move(title),
              {"iteration", Scale::log10, {}, {}, true},
              {std::move(label), Scale::linear, 0., {}, false},
              {}};
    for (const Benchmark_record* benchmark : benchmarks) {
        Series s{benchmark->name.substr(benchmark->name.find('-') + 1), {}, {}};
        for (const Quality_record& q : benchmark->qualities) {
            if (q.step == 0) continue;
            s.x.push_back(static_cast<double>(q.step));
            s.y.push_back(value(q));
        }
        plot.series.push_back(std::move(s));
    }
    return plot;
}

double slivers(const Quality_record& q) {
    return q.cells > 0 ? 100 * static_cast<double>(q.slivers) / static_cast<double>(q.cells) : 0;
}
double locked(const Quality_record& q) {
    return q.vertices > 0 ? 100 * static_cast<double>(q.locked) / static_cast<double>(q.vertices) : 0;
}

Page_content quality_page(const Reproduction& r) {
    Page_content page{"figure-9", "Figure 9: what more iterations are worth",
                      "A man (CGAL's, which need not be the paper's) at the start and after 100 and 1,000 iterations: "
                      "cuts, dihedral angles, slivers."};
    const Benchmark_record* man = r.benchmark("nodt-man");
    if (!man) man = r.benchmark("nodt-sphere");
    if (!man) return page;
    if (man->name != "nodt-man") page.notes.push_back("The sphere, since there was no --surfaces.");
    std::vector<Panel> panels;
    const std::uint64_t middle = std::min<std::uint64_t>(100, man->steps);
    append_pictures(*man, {0, middle, man->steps}, panels, "figure-9-quality.csv");
    page.sections.emplace_back("Cuts", std::move(panels));
    panels.clear();
    Plot plot{"Dihedral angles",
              {"dihedral angle (degrees)", Scale::linear, 0., 180., true},
              {"angles in a bin of 5 degrees (%)", Scale::linear, 0., {}, false},
              {}};
    for (const Quality_record& q : man->qualities)
        if (q.step == 0 || q.step == middle || q.step == man->steps) plot.series.push_back(angles(q));
    append_plot(page, panels, plot, "figure-9.csv");
    append_plot(page, panels, over_iterations("Slivers", "cells that are slivers (%)", meshes(r), slivers),
                "figure-9-slivers.csv", "A dihedral angle below 10 or above 170 degrees.");
    page.sections.emplace_back("Quality", std::move(panels));
    page.tables.emplace_back("figure-9-quality.csv", quality_table(*man));
    return page;
}

}  // namespace

void append_mesh_pages(const Reproduction& r, std::vector<Page_content>& out) {
    Page_content eight{"figure-8", "Figure 8: meshes before and after",
                       "Cuts through the meshes at the start and after natural ODT."};
    for (const Benchmark_record* benchmark : meshes(r)) {
        std::vector<Panel> panels;
        const std::string csv = "figure-8-" + benchmark->name.substr(5) + ".csv";
        append_pictures(*benchmark, {0, benchmark->steps}, panels, csv);
        eight.sections.emplace_back(body_of(*benchmark) + ", " + grouped(benchmark->vertices) + " vertices",
                                    std::move(panels));
        eight.tables.emplace_back(csv, quality_table(*benchmark));
        for (const std::string& note : benchmark->notes) eight.notes.push_back(body_of(*benchmark) + ": " + note);
    }
    out.push_back(std::move(eight));
    out.push_back(quality_page(r));

    Page_content ten{"figure-10", "Figure 10: statistics in space",
                     "Natural ODT of the sphere, as figure 6: (a) means over the iterations; (b) widths. The unit is "
                     "the cube root of the ball's volume per vertex."};
    if (const Benchmark_record* sphere = r.benchmark("nodt-sphere")) {
        std::vector<Panel> panels;
        append_plot(ten, panels, convergence_plot(*sphere), "figure-10a.csv",
                    "\"Tolerance\" is the paper's, which is too large at some vertices; \"certified\" is ours.");
        append_plot(ten, panels, width_plot(*sphere), "figure-10b.csv", "Of the paper's standard annuli.");
        ten.sections.emplace_back("Sphere", std::move(panels));
    }
    out.push_back(std::move(ten));

    Page_content graded{"slivers", "Variable sizing and slivers",
                        "The paper says that in meshes with variable sizing going from 100 to 1,000 iterations leaves "
                        "15 % less slivers."};
    if (const auto benchmarks = present(r, {"graded-sphere", "graded-bunny"}); !benchmarks.empty()) {
        std::vector<Panel> panels;
        append_plot(graded, panels, over_iterations("Slivers", "cells that are slivers (%)", benchmarks, slivers),
                    "slivers.csv");
        graded.sections.emplace_back("Edges longer away from the surface", std::move(panels));
    }
    out.push_back(std::move(graded));

    Page_content locks{"locked", "Locked vertices",
                       "Vertices all of whose cells are good rest. The paper reports that in the end 95 % do, while it "
                       "refines the mesh; here there is no refinement."};
    if (const auto benchmarks = present(r, {"locked-sphere", "locked-bunny"}); !benchmarks.empty()) {
        std::vector<Panel> panels;
        append_plot(locks, panels, over_iterations("Locked vertices", "vertices (%)", benchmarks, locked), "locked.csv",
                    "Good: all dihedral angles between 15 and 165 degrees.");
        locks.sections.emplace_back("Locks of 15 degrees", std::move(panels));
    }
    out.push_back(std::move(locks));
}

}  // namespace annulus::inline v1
