// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_words.h>
#include <apps/reproduction/figures.h>

// Figures 5 to 7: Lloyd iterations.
namespace annulus::inline v1 {

namespace {

std::string density_in_words(const std::string& benchmark) {
    return benchmark.ends_with("-one")     ? "density 1"
           : benchmark.ends_with("-x2+y2") ? "density x² + y²"
           : benchmark.ends_with("-x2")    ? "density x²"
                                           : "density sin² of the radius";
}

void append_pictures(const Benchmark_record& benchmark, const std::string& csv, Page_content& page,
                     std::vector<Panel>& panels) {
    for (const Picture_record& p : benchmark.pictures) {
        const std::string name = csv + "-" + std::to_string(p.step) + ".csv";
        panels.push_back({density_in_words(benchmark.name) + ", " + caption_of(p), p.svg, "", {name}});
        Csv_table table{{"x", "y"}, {}};
        for (std::size_t i = 0; i < p.x.size(); ++i) table.rows.push_back({p.x[i], p.y[i]});
        page.tables.emplace_back(name, std::move(table));
    }
}

/// Names of curves for display.
constexpr std::pair<const char*, const char*> curves[] = {{"rebuild", "rebuilding (CGAL)"},
                                                          {"relocate-cgal", "relocation (CGAL)"},
                                                          {"relocate", "relocation"},
                                                          {"paper-printed", "paper's filter"},
                                                          {"paper-in-place", "with tests in place"},
                                                          {"tolerances-each", "one by one"},
                                                          {"auto", "auto"}};

Plot time_plot(const Benchmark_record& benchmark, bool logarithmic) {
    Plot plot{density_in_words(benchmark.name),
              {"iteration", logarithmic ? Scale::log10 : Scale::linear, {}, {}, true},
              {"cumulated time (s)", logarithmic ? Scale::log10 : Scale::linear, {}, {}, false},
              {}};
    if (!logarithmic) plot.x.lower = plot.y.lower = 0.;
    for (const auto& [name, words] : curves) {
        const Contender_record* r = contender_of(benchmark, name);
        if (!r) continue;
        Series s{words, {}, {}};
        for (const auto& [step, seconds] : cumulated(*r)) {
            if (logarithmic && step == 0) continue;  // what a strategy computes before the first step, or nothing
            s.x.push_back(static_cast<double>(step));
            s.y.push_back(seconds);
        }
        plot.series.push_back(std::move(s));
    }
    return plot;
}

}  // namespace

void append_plane_pages(const Reproduction& r, std::vector<Page_content>& out) {
    Page_content five{
        "figure-5", "Figure 5: points before and after Lloyd iterations",
        "Points drawn from a disc with a density, and where Lloyd iterations with the same density take them."};
    std::vector<Panel> panels;
    for (const Benchmark_record* benchmark : present(r, {"points-one", "points-x2"}))
        append_pictures(*benchmark, "figure-5-" + benchmark->name.substr(7), five, panels);
    if (!panels.empty()) five.sections.emplace_back("Points", std::move(panels));
    out.push_back(std::move(five));

    Page_content six{"figure-6", "Figure 6: statistics in the plane",
                     "Lloyd iterations with density x²: (a) how far points go, how wide standard annuli are and what "
                     "tolerance vertices have, all means; (b) how the widths are distributed. The unit is the square "
                     "root of the disc's area per point."};
    if (const Benchmark_record* x2 = r.benchmark("lloyd-x2")) {
        panels.clear();
        append_plot(six, panels, convergence_plot(*x2), "figure-6a.csv",
                    "Before each step; the displacement is that of the step. Certified tolerances are the paper's but "
                    "for rounding.");
        append_plot(six, panels, width_plot(*x2), "figure-6b.csv");
        six.sections.emplace_back("Density x²", std::move(panels));
    }
    out.push_back(std::move(six));

    Page_content seven{
        "figure-7", "Figure 7: computation times in the plane",
        "Cumulated time of Lloyd iterations under each strategy, for four densities. \"Paper's filter\" "
        "is its algorithm (3.2) as printed, on the library's mesh: tolerances in plain double, and a vertex that fails "
        "is removed and inserted again; \"with tests in place\" is the same with its 3.1, which relocates only where "
        "cells have to change. Rebuilding is CGAL's insertion of a range; relocation is on the library's mesh, and by "
        "CGAL's insertion and removal. Of ours \"one by one\" is tolerances-each with certified tolerances, \"auto\" "
        "moves whole time steps."};
    std::vector<Panel> linear, logarithmic;
    char letter = 'a';
    for (const Benchmark_record* benchmark : present(r, {"lloyd-one", "lloyd-x2+y2", "lloyd-x2", "lloyd-sin2"})) {
        const std::string csv = std::string("figure-7") + letter++;
        append_plot(seven, linear, time_plot(*benchmark, false), csv + ".csv",
                    grouped(benchmark->vertices) + " points");
        Page_content scratch;  // the numbers are the same
        append_plot(scratch, logarithmic, time_plot(*benchmark, true), csv + ".csv");
    }
    if (!linear.empty()) {
        seven.sections.emplace_back("Cumulated times", std::move(linear));
        seven.sections.emplace_back("The same on logarithmic axes", std::move(logarithmic));
        seven.notes.push_back(
            "Seconds of one thread's processor, all strategies in turn on the same 25 steps. Relocation is timed at "
            "every tenth step (of 1,000), on a copy that is built at the positions before it; steps between count as "
            "the next one that was timed. The paper's filter relocates a vertex as \"relocation\" does, not as "
            "\"relocation (CGAL)\" does.");
    }
    out.push_back(std::move(seven));
}

}  // namespace annulus::inline v1
