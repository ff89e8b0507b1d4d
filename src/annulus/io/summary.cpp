// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/arithmetic/error.h>
#include <annulus/io/summary.h>

namespace annulus {

namespace {

using Json = nlohmann::ordered_json;

Csv_cell cell(const std::optional<double>& value) { return value ? Csv_cell(*value) : Csv_cell(); }

}  // namespace

Json summary_json(const Run_record& run) {
    Json json;
    json["command"] = run.command;
    json["dimension"] = run.dimension;
    json["vertices"] = run.vertices;
    json["iterations"] = run.iterations;
    json["strategy"] = run.strategy;
    json["tolerance"] = run.tolerance;
    json["threads"] = run.threads;
    json["seed"] = run.seed;
    json["seconds"] = Json{
        {"triangulation", run.seconds.triangulation}, {"motion", run.seconds.motion}, {"total", run.seconds.total}};
    json["moves"] = Json{{"asked", run.moves.asked},
                         {"within_tolerance", run.moves.within_tolerance},
                         {"kept_in_place", run.moves.kept_in_place},
                         {"flipped", run.moves.flipped},
                         {"reinserted", run.moves.reinserted},
                         {"rebuilt", run.moves.rebuilt}};
    json["arithmetic"] =
        Json{{"filter", run.arithmetic.filter}, {"interval", run.arithmetic.interval}, {"exact", run.arithmetic.exact}};
    json["audit"] = Json{{"checked", run.audit.checked}, {"failed", run.audit.failed}};
    json["memory"] = Json{{"peak_bytes", run.memory_peak_bytes}};
    json["mean_spacing"] = run.mean_spacing;
    return json;
}

Json compare_json(const Comparison_record& comparison) {
    Json json;
    json["agree"] = comparison.agree;
    Json& strategies = json["strategies"] = Json::object();
    for (const Run_record& run : comparison.runs) {
        if (strategies.contains(run.strategy))
            throw Error(Error_code::usage, "compare_json: two runs of the strategy " + run.strategy);
        strategies[run.strategy] = summary_json(run);
    }
    Json ratios = Json::object();
    for (const Run_record& a : comparison.runs)
        for (const Run_record& b : comparison.runs)
            if (&a != &b) {
                Json& ratio = ratios[a.strategy + "/" + b.strategy];
                if (b.seconds.triangulation > 0) ratio = a.seconds.triangulation / b.seconds.triangulation;
            }
    json["ratios"] = std::move(ratios);
    if (!comparison.disagreements.empty()) json["disagreements"] = comparison.disagreements;
    return json;
}

Csv_table iterations_table(const Run_record& run) {
    Csv_table table;
    table.header = {"iteration",
                    "seconds_triangulation",
                    "seconds_motion",
                    "seconds_cumulative",
                    "displacement_mean",
                    "displacement_max",
                    "tolerance_mean",
                    "annulus_width_mean",
                    "theta_min",
                    "asked",
                    "within_tolerance",
                    "kept_in_place",
                    "flipped",
                    "reinserted",
                    "rebuilt",
                    "filter",
                    "interval",
                    "exact",
                    "certificates_evaluated",
                    "flips"};
    table.rows.reserve(run.steps.size());
    for (const Iteration_record& s : run.steps)
        table.rows.push_back(
            {s.iteration,           s.seconds_triangulation, s.seconds_motion,         s.seconds_cumulative,
             s.displacement_mean,   s.displacement_max,      cell(s.tolerance_mean),   cell(s.annulus_width_mean),
             cell(s.theta_min),     s.moves.asked,           s.moves.within_tolerance, s.moves.kept_in_place,
             s.moves.flipped,       s.moves.reinserted,      s.moves.rebuilt,          s.arithmetic.filter,
             s.arithmetic.interval, s.arithmetic.exact,      s.certificates_evaluated, s.flips});
    return table;
}

}  // namespace annulus
