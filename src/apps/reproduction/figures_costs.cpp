// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_words.h>
#include <apps/reproduction/figures.h>

#include <cstdlib>

// Figures 11 and 12: failures, updates, speed-up.
namespace annulus::inline v1 {

namespace {

std::string name_of_curve(const Benchmark_record& benchmark) {
    if (benchmark.name == "lloyd-x2") return "Lloyd, x²";
    return benchmark.name.substr(benchmark.name.find('-') + 1);
}

/// Means over a thirtieth of a decade, which make curves readable.
template <class Value>
Series smoothed(std::string name, const Contender_record& r, Value value) {
    Series s{std::move(name), {}, {}};
    for (std::size_t k = 0; k < r.step.size();) {
        double part = 0, all = 0, steps = 0, n = 0;
        const double end = static_cast<double>(r.step[k]) * 1.08;
        for (; k < r.step.size() && (n == 0 || static_cast<double>(r.step[k]) < end); ++k, ++n) {
            const auto [a, b] = value(k);
            part += a;
            all += b;
            steps += static_cast<double>(r.step[k]);
        }
        if (all <= 0) continue;
        s.x.push_back(steps / n);
        s.y.push_back(part / all);
    }
    return s;
}

Plot failure_plot(const std::vector<const Benchmark_record*>& benchmarks, const char* contender) {
    Plot plot{"Failures",
              {"iteration", Scale::log10, {}, {}, true},
              {"moves beyond their tolerance (%)", Scale::linear, 0., 100., false},
              {}};
    for (const Benchmark_record* benchmark : benchmarks)
        if (const Contender_record* r = contender_of(*benchmark, contender))
            plot.series.push_back(smoothed(name_of_curve(*benchmark), *r, [&](std::size_t k) {
                return std::pair(100 * static_cast<double>(r->failed[k]), static_cast<double>(r->asked[k]));
            }));
    return plot;
}

Plot update_plot(const std::vector<const Benchmark_record*>& benchmarks, const char* contender) {
    Plot plot{"Updates a failure",
              {"iteration", Scale::log10, {}, {}, true},
              {"tolerances computed a failed move", Scale::linear, 0., {}, false},
              {}};
    for (const Benchmark_record* benchmark : benchmarks)
        if (const Contender_record* r = contender_of(*benchmark, contender))
            plot.series.push_back(smoothed(name_of_curve(*benchmark), *r, [&](std::size_t k) {
                return std::pair(static_cast<double>(r->evaluated[k]), static_cast<double>(r->failed[k]));
            }));
    return plot;
}

/// The cumulative speed-up over rebuilding.
Plot speed_plot(std::string title, const std::vector<const Benchmark_record*>& benchmarks, const char* contender,
                bool relocation) {
    Plot plot{std::move(title),
              {"iteration", Scale::log10, {}, {}, true},
              {"times as fast as rebuilding", Scale::log10, {}, {}, false},
              {}};
    const auto add = [&](const Benchmark_record& benchmark, const char* name, std::string words) {
        const Contender_record *r = contender_of(benchmark, name), *rebuild = contender_of(benchmark, "rebuild");
        if (!r || !rebuild || rebuild->step.empty()) return;
        const auto all = cumulated(*rebuild);
        const double a_step = all.back().second / static_cast<double>(all.back().first);
        Series s{std::move(words), {}, {}};
        for (const auto& [step, seconds] : cumulated(*r)) {
            if (step == 0 || seconds <= 0) continue;
            s.x.push_back(static_cast<double>(step));
            s.y.push_back(a_step * static_cast<double>(step) / seconds);
        }
        plot.series.push_back(std::move(s));
    };
    for (const Benchmark_record* benchmark : benchmarks) add(*benchmark, contender, name_of_curve(*benchmark));
    if (relocation && !benchmarks.empty())
        add(*benchmarks.front(), "relocate-cgal", "CGAL's relocation (" + name_of_curve(*benchmarks.front()) + ")");
    return plot;
}

Plot relocation_plot(const std::vector<const Benchmark_record*>& benchmarks) {
    Plot plot = speed_plot("Relocation by CGAL", benchmarks, "relocate-cgal", false);
    plot.y.scale = Scale::linear;
    plot.y.lower = 0.;
    return plot;
}

/// The cost of a time step in rebuilds, by the share of points that move.
Plot movers_plot(const Reproduction& r, const char* where) {
    Plot plot{std::string("Random points, ") + where,
              {"points that move (%)", Scale::log10, {}, {}, true},
              {"time of a time step (rebuilds)", Scale::log10, {}, {}, false},
              {}};
    for (const auto& [contender, words] :
         {std::pair("relocate-cgal", "relocation (CGAL)"), std::pair("relocate", "relocation"),
          std::pair("paper-printed", "paper's filter"), std::pair("tolerances-each", "one by one"),
          std::pair("auto", "auto")}) {
        Series s{words, {}, {}};
        for (const char* share : {"1", "10", "100"})
            if (const Benchmark_record* benchmark = r.benchmark(std::string("movers-") + where + "-" + share))
                if (const double x = speed_up(*benchmark, contender, "rebuild"); x > 0) {
                    s.x.push_back(std::atof(share));
                    s.y.push_back(x);
                }
        if (!s.x.empty()) plot.series.push_back(std::move(s));
    }
    return plot;
}

}  // namespace

void append_cost_pages(const Reproduction& r, std::vector<Page_content>& out) {
    Page_content eleven{
        "figure-11", "Figure 11: failures, and updates a failure",
        "The share of moves that the filter does not let pass, and how many tolerances are computed for each of them, "
        "along the iterations: (a, b) Lloyd with density x² and the bunny, (c, d) bunny and sphere."};
    for (const auto& [contender, heading] :
         {std::pair("paper-printed", "The paper's algorithm as printed"),
          std::pair("tolerances-each", "Certified tolerances, one vertex at a time")}) {
        std::vector<Panel> panels;
        const std::string suffix = std::string(contender) == "paper-printed" ? "" : "-certified";
        const auto a = present(r, {"lloyd-x2", "nodt-bunny"}), c = present(r, {"nodt-bunny", "nodt-sphere"});
        append_plot(eleven, panels, failure_plot(a, contender), "figure-11a" + suffix + ".csv");
        append_plot(eleven, panels, update_plot(a, contender), "figure-11b" + suffix + ".csv");
        append_plot(eleven, panels, failure_plot(c, contender), "figure-11c" + suffix + ".csv");
        append_plot(eleven, panels, update_plot(c, contender), "figure-11d" + suffix + ".csv");
        if (!panels.empty()) eleven.sections.emplace_back(heading, std::move(panels));
    }
    if (!eleven.sections.empty())
        eleven.notes.push_back(
            "Means over steps a twelfth apart. Where few moves fail, updates a failure scatter. Of the printed "
            "algorithm an update is a new bi-cell, of the certified one a certificate that expired; certified "
            "tolerances are not smaller in the plane; tolerances-each turns to signs where no tolerances pay, and a "
            "move "
            "then counts as failed.");
    out.push_back(std::move(eleven));

    Page_content twelve{"figure-12", "Figure 12: speed-up against rebuilding",
                        "Cumulated time of CGAL's insertion of a range over that of each strategy, along the "
                        "iterations of natural ODT."};
    if (const auto benchmarks = meshes(r); !benchmarks.empty()) {
        std::vector<Panel> panels;
        append_plot(twelve, panels, speed_plot("The paper's algorithm as printed", benchmarks, "paper-printed", true),
                    "figure-12.csv", "As the paper's figure.");
        append_plot(twelve, panels,
                    speed_plot("The same, tested in place first (3.1)", benchmarks, "paper-in-place", false),
                    "figure-12-in-place.csv");
        append_plot(
            twelve, panels,
            speed_plot("Certified, one vertex at a time (tolerances-each)", benchmarks, "tolerances-each", false),
            "figure-12-tolerances-each.csv");
        append_plot(twelve, panels, speed_plot("Certified, whole time steps (auto)", benchmarks, "auto", false),
                    "figure-12-auto.csv");
        append_plot(twelve, panels, relocation_plot(benchmarks), "figure-12-relocate.csv",
                    "At the steps that were timed.");
        twelve.sections.emplace_back("Speed-up", std::move(panels));
        twelve.notes.push_back(
            "Seconds of one thread's processor, all strategies in turn on the same 25 steps. Of 1,000 steps rebuilding "
            "is timed at every fourth and relocation at every 50th, on a copy that is built at the positions before "
            "it: over all of them it would take far longer than all else.");
        twelve.notes.push_back(
            "The paper's algorithm as printed (3.2) relocates each vertex that fails: it is removed from the library's "
            "mesh and inserted again at its new place. Its 3.1 tests in place beforehand, and relocates only where "
            "cells have to change. Neither flips in space. Rebuilding and relocation in these plots are CGAL's, as the "
            "paper's were.");
    }
    out.push_back(std::move(twelve));

    Page_content movers{
        "movers", "When only some points move",
        "The paper says that rebuilding is not best when only a fraction of the points moves, since relocating m of "
        "them costs O(m). Uniform random points, of which a share goes a twentieth of a mean spacing at each step."};
    std::vector<Panel> panels;
    for (const char* where : {"plane", "space"})
        append_plot(movers, panels, movers_plot(r, where), std::string("movers-") + where + ".csv");
    if (!panels.empty()) movers.sections.emplace_back("Cost of a time step", std::move(panels));
    out.push_back(std::move(movers));
}

}  // namespace annulus::inline v1
