// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/axis_ticks.h>
#include <apps/report/box_change.h>
#include <apps/report/report_plots.h>

#include <algorithm>
#include <limits>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// A curve over the iterations; absent values are gaps.
template <class Value>
Series over_iterations(std::string name, const std::vector<Iteration_record>& steps, Value value) {
    Series series;
    series.name = std::move(name);
    for (const Iteration_record& step : steps) {
        const std::optional<double> y = value(step);
        series.x.push_back(static_cast<double>(step.iteration));
        series.y.push_back(y.value_or(nan));
    }
    return series;
}

/// Values that were measured only in some steps are joined across the others.
template <class Value>
void add_measured(std::vector<Series>& all, std::string name, const std::vector<Iteration_record>& steps, Value value) {
    Series series;
    series.name = std::move(name);
    for (const Iteration_record& step : steps) {
        const std::optional<double> y = value(step);
        if (!y) continue;
        series.x.push_back(static_cast<double>(step.iteration));
        series.y.push_back(*y);
    }
    if (!series.x.empty()) all.push_back(std::move(series));
}

/// An axis that has the start, too, as 0, or where steps are many, logarithmic, as 1.
bool begins_at_one(const Run_record& run) { return run.steps.size() > 50; }
Axis axis_from_start(const Run_record& run) {
    const bool one = begins_at_one(run);
    return {(one ? "1 + " : "") + std::string(step_axis_label(run)), one ? Scale::log10 : Scale::linear, {}, {}, true};
}
/// Puts the value at the start before a curve over the steps.
void begin_with(Series& series, const Run_record& run, std::optional<double> start) {
    if (start) {
        series.x.insert(series.x.begin(), 0);
        series.y.insert(series.y.begin(), *start);
    }
    if (begins_at_one(run))
        for (double& x : series.x) ++x;
}

/// How the volumes of Voronoi cells scatter; empty where that was not measured.
Series scatter_curve(const Run_record& run) {
    std::vector<Series> all;
    add_measured(all, "", run.steps, [](const Iteration_record& s) {
        return s.volume_scatter ? std::optional(100 * *s.volume_scatter) : std::nullopt;
    });
    if (all.empty() || all.front().x.size() < 2) return {};
    begin_with(all.front(), run,
               run.volume_scatter_before ? std::optional(100 * *run.volume_scatter_before) : std::nullopt);
    return std::move(all.front());
}

Axis step_axis(const Run_record& run, Scale scale) { return {step_axis_label(run), scale, {}, {}, true}; }

/// "iteration 10", or of a replayed motion, whose frames have numbers of their own, "after 10 frames".
std::string label_of(const Run_record& run, std::uint64_t step) {
    if (run.finished && step == run.iterations) return "the finish";
    return run.replayed ? "after " + grouped(step) + (step == 1 ? " frame" : " frames") : "iteration " + grouped(step);
}

}  // namespace

std::vector<Plot> convergence_plots(const Report& report) {
    std::vector<Plot> plots;
    const auto& steps = report.run.steps;
    if (!steps.empty() && !only_box_moves(report.run)) {
        Plot plot{"",
                  step_axis(report.run, Scale::log10),
                  {"mean over vertices (mean spacings)", Scale::log10, {}, {}, false},
                  {}};
        add_measured(plot.series, "displacement", steps,
                     [](const Iteration_record& s) { return std::optional<double>(s.displacement_mean); });
        add_measured(plot.series, "tolerance", steps, [](const Iteration_record& s) { return s.tolerance_mean; });
        add_measured(plot.series, "annulus width", steps,
                     [](const Iteration_record& s) { return s.annulus_width_mean; });
        for (const Series& s : plot.series) plot.title += (plot.title.empty() ? "" : ", ") + s.name;
        plot.title[0] = 'D';  // displacement, which all runs have
        if (box_changes(report.run)) plot.title += ", relative to the box";
        // Displacements alone are among the figures of a replayed motion.
        if (plot.series.size() > 1 || !report.run.replayed || report.figures.empty()) plots.push_back(std::move(plot));
    }
    if (!report.annulus_widths.empty()) {
        const bool logarithmic = report.annulus_widths.front().widths.logarithmic();
        // In 3D the width is the least of four annuli.
        const std::string annulus = report.run.dimension == 2 ? "standard annulus" : "annulus";
        Plot plot{"Distribution of " + annulus + " widths",
                  {annulus + " width (mean spacings)", logarithmic ? Scale::log10 : Scale::linear, {}, {}, true},
                  {"bi-cells in a bin (%)", Scale::linear, 0., {}, false},
                  {}};
        for (const Width_distribution& d : report.annulus_widths)
            plot.series.push_back(histogram_series(label_of(report.run, d.iteration), d.widths));
        plots.push_back(std::move(plot));
    }
    return plots;
}

std::vector<Plot> cost_plots(const Run_record& run) {
    std::vector<Plot> plots;
    if (run.steps.empty()) return plots;
    const auto tested = [](const Iteration_record& s) { return s.tested_tolerances && s.moves.asked > 0; };
    const auto first = std::find_if(run.steps.begin(), run.steps.end(), tested);
    if (first != run.steps.end()) {
        Plot plot{"Moves beyond their tolerance",
                  step_axis(run, Scale::log10),
                  {"moves beyond tolerance (%)", Scale::linear, 0., {}, false},
                  {}};
        plot.series.push_back(over_iterations("", run.steps, [&](const Iteration_record& s) -> std::optional<double> {
            if (!tested(s)) return std::nullopt;
            const double within = static_cast<double>(s.moves.within_tolerance) / static_cast<double>(s.moves.asked);
            return 100 * (1 - within);
        }));
        if (first->iteration > 1) {  // a logarithmic axis from 1 would squeeze what is far from there
            plot.x.scale = Scale::linear;
            plot.x.lower = static_cast<double>(first->iteration);
        }
        plots.push_back(std::move(plot));
    }
    const std::string word = step_word(run);
    Plot plot{"Time for each " + word, step_axis(run, Scale::log10), {"time (ms)", Scale::log10, {}, {}, false}, {}};
    plot.series.push_back(over_iterations("triangulation", run.steps, [](const Iteration_record& s) {
        return std::optional<double>(1e3 * s.seconds_triangulation);
    }));
    if (run.seconds.motion > 0)
        plot.series.push_back(over_iterations("motion", run.steps, [](const Iteration_record& s) {
            return std::optional<double>(1e3 * s.seconds_motion);
        }));
    plots.push_back(std::move(plot));
    return plots;
}

std::vector<Plot> mesh_plots(const Run_record& run) {
    if (!run.mesh_before) return {};
    const auto angles = [](std::string name, const Mesh_step& mesh) {
        Series series{std::move(name), {0}, {}, true};
        double sum = 0;
        for (const std::uint64_t n : mesh.dihedral) sum += static_cast<double>(n);
        for (const std::uint64_t n : mesh.dihedral) {
            series.x.push_back(5 * static_cast<double>(series.x.size()));
            series.y.push_back(sum > 0 ? 100 * static_cast<double>(n) / sum : 0);
        }
        return series;
    };
    Plot dihedral{"Dihedral angles",
                  {"dihedral angle (degrees)", Scale::linear, 0., 180., true},
                  {"angles in a bin of 5 degrees (%)", Scale::linear, 0., {}, false},
                  {angles("before", *run.mesh_before)}};
    if (!run.steps.empty() && run.steps.back().mesh) dihedral.series.push_back(angles("after", *run.steps.back().mesh));
    std::vector<Plot> plots{dihedral};
    Plot slivers{"Slivers", axis_from_start(run), {"cells that are slivers (%)", Scale::linear, 0., {}, false}, {}};
    Plot locked{"Locked vertices", step_axis(run, Scale::log10), {"vertices (%)", Scale::linear, 0., {}, false}, {}};
    const auto share = [](std::uint64_t part, std::uint64_t all) {
        return all > 0 ? 100 * static_cast<double>(part) / static_cast<double>(all) : 0;
    };
    add_measured(slivers.series, "", run.steps, [&](const Iteration_record& s) {
        return s.mesh ? std::optional(share(s.mesh->slivers, s.mesh->cells)) : std::nullopt;
    });
    if (!slivers.series.empty())
        begin_with(slivers.series.front(), run, share(run.mesh_before->slivers, run.mesh_before->cells));
    bool any = false;
    for (const Iteration_record& s : run.steps) any = any || (s.mesh && s.mesh->locked > 0);
    if (any)
        add_measured(locked.series, "", run.steps, [&](const Iteration_record& s) {
            return s.mesh ? std::optional(share(s.mesh->locked, s.mesh->vertices)) : std::nullopt;
        });
    for (Plot* plot : {&slivers, &locked})
        if (!plot->series.empty()) plots.push_back(std::move(*plot));
    return plots;
}

std::vector<Plot> regularity_plots(const Run_record& run) {
    const auto curve = [&](std::string name, auto value) {
        std::vector<Series> all;  // of two measured steps or more, and the start
        add_measured(all, std::move(name), run.steps, [&](const Iteration_record& s) -> std::optional<double> {
            return s.plane ? value(*s.plane) : std::nullopt;
        });
        if (all.empty() || all.front().x.size() < 2) return Series{};
        begin_with(all.front(), run, run.plane_before ? std::optional<double>(value(*run.plane_before)) : std::nullopt);
        return std::move(all.front());
    };
    const auto share = [&](std::string name, std::size_t which) {
        return curve(std::move(name), [which](const Plane_step& p) {
            return p.inner == 0
                       ? std::nullopt
                       : std::optional(100 * static_cast<double>(p.neighbours[which]) / static_cast<double>(p.inner));
        });
    };
    const char* const counted = run.input.box.empty() ? "inner vertices (%)" : "vertices (%)";
    const double first = run.plane_before && run.plane_before->energy ? *run.plane_before->energy : 0;
    std::vector<Plot> plots{{"Numbers of neighbours",
                             axis_from_start(run),
                             {counted, Scale::linear, 0., {}, false},
                             {share("seven", 3), share("five", 1), share("six", 2)}},
                            {"Least angles of triangles",
                             axis_from_start(run),
                             {"angle (degrees)", Scale::linear, 0., 60., false},
                             {curve("mean", [](const Plane_step& p) { return std::optional(p.angle_mean); }),
                              curve("least", [](const Plane_step& p) { return std::optional(p.angle_min); })}},
                            {"Energy",
                             axis_from_start(run),
                             {"energy (% of that at the start)", Scale::linear, {}, {}, false},
                             {curve("",
                                    [&](const Plane_step& p) {
                                        return p.energy && first > 0 ? std::optional(100 * *p.energy / first)
                                                                     : std::nullopt;
                                    })}},
                            {"Volumes of Voronoi cells",
                             axis_from_start(run),
                             {"standard deviation (% of the mean)", Scale::linear, 0., {}, false},
                             {scatter_curve(run)}}};
    for (Plot& plot : plots) std::erase_if(plot.series, [](const Series& s) { return s.x.size() < 2; });
    std::erase_if(plots, [](const Plot& plot) { return plot.series.empty(); });
    return plots;
}

std::vector<Plot> comparison_plots(const Comparison_record& comparison) {
    std::vector<Series> curves;
    for (const Run_record& run : comparison.runs)
        add_measured(curves, run.strategy, run.steps,
                     [](const Iteration_record& s) { return std::optional<double>(s.seconds_cumulative); });
    // One step is in the table.
    if (std::none_of(curves.begin(), curves.end(), [](const Series& s) { return s.x.size() > 1; })) return {};
    return {{"Cumulative time of each strategy",
             step_axis(comparison.runs.front(), Scale::linear),
             {"cumulative time (s)", Scale::linear, 0., {}, false},
             curves},
            {"Cumulative time of each strategy, logarithmic",
             step_axis(comparison.runs.front(), Scale::log10),
             {"cumulative time (s)", Scale::log10, {}, {}, false},
             curves}};
}

}  // namespace annulus::inline v1
