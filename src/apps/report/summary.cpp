// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <annulus/version.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/finding.h>
#include <apps/report/summary.h>

namespace annulus::inline v1 {

namespace {

using Json = nlohmann::ordered_json;

Csv_cell cell(const std::optional<double>& value) { return value ? Csv_cell(*value) : Csv_cell(); }

Json mesh_json(const Mesh_step& m) {
    return Json{{"vertices", m.vertices},
                {"boundary", m.boundary},
                {"locked", m.locked},
                {"cells", m.cells},
                {"slivers", m.slivers},
                {"dihedral_min", m.dihedral_min},
                {"dihedral_max", m.dihedral_max},
                {"dihedral_degrees_5", m.dihedral}};
}

Json worst_json(const std::vector<Worst_cell>& cells) {
    Json worst = Json::array();
    for (const Worst_cell& c : cells)
        worst.push_back(Json{{"cell", c.cell},
                             {"dihedral_min", c.dihedral_min},
                             {"radius_ratio", c.radius_ratio},
                             {"aspect", c.aspect},
                             {"at", c.at}});
    return worst;
}

void append_mesh(std::vector<Csv_cell>& row, const Iteration_record& s) {
    const std::uint64_t failures = s.moves.asked - s.moves.within_tolerance;
    row.push_back(failures);
    row.push_back(failures == 0
                      ? Csv_cell()
                      : Csv_cell(static_cast<double>(s.certificates_evaluated) / static_cast<double>(failures)));
    if (!s.mesh) {
        row.resize(row.size() + 8);
        return;
    }
    const Mesh_step& m = *s.mesh;
    row.insert(row.end(),
               {m.vertices, m.boundary, m.locked, m.kept, m.cells, m.slivers, m.dihedral_min, m.dihedral_max});
}

}  // namespace

void append_input(Json& json, const Input_record& input) {
    if (!input.columns.empty()) {
        Json& columns = json["columns"] = Json::object();
        for (const auto& [what, where] : input.columns) columns[what] = where;
    }
    if (!input.box.empty()) json["box"] = input.box;
    if (!input.ignored.empty()) json["ignored"] = input.ignored;
}

std::string in_words(const Clip_record& clip) {
    if (clip.kind == "polygon") return "a polygon with " + grouped(clip.rows.size(), "corner");
    if (clip.kind != "box") return grouped(clip.rows.size(), "half-space");
    const auto corner = [](const std::vector<double>& x) {
        std::string text;
        for (const double c : x) text += (text.empty() ? "(" : ", ") + readable(c);
        return text + ")";
    };
    return "a box from " + corner(clip.rows.front()) + " to " + corner(clip.rows.back());
}

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
    json["version"] = ANNULUS_VERSION_STRING;
    json["seconds_construction"] = run.seconds.construction;
    if (run.interrupted) json["interrupted"] = true;
    json["memory"] = Json{{"peak_bytes", run.memory_peak_bytes == 0 ? Json() : Json(run.memory_peak_bytes)}};
    json["mean_spacing"] = run.mean_spacing;
    append_input(json, run.input);
    if (run.clip) json["clip"] = Json{{"kind", run.clip->kind}, {"rows", run.clip->rows}};
    if (run.mesh_before) {
        Json& mesh = json["mesh"];
        mesh["before"] = mesh_json(*run.mesh_before);
        const bool measured = !run.steps.empty() && run.steps.back().mesh;
        mesh["after"] = mesh_json(measured ? *run.steps.back().mesh : *run.mesh_before);
        if (!run.worst.empty()) mesh["worst"] = worst_json(run.worst);
    }
    return json;
}

Json compare_json(const Comparison_record& comparison) {
    Json json;
    if (!comparison.runs.empty()) json["command"] = comparison.runs[0].command;
    json["version"] = ANNULUS_VERSION_STRING;
    if (comparison.interrupted) json["interrupted"] = true;
    else json["agree"] = comparison.agree;
    if (!comparison.runs.empty()) append_input(json, comparison.runs[0].input);
    Json& strategies = json["strategies"] = Json::object();
    for (const Run_record& run : comparison.runs) {
        if (strategies.contains(run.strategy))
            throw Error(Error_code::usage, "compare_json: two runs of the strategy " + run.strategy);
        strategies[run.strategy] = summary_json(run);
    }
    if (comparison.interrupted) return json;
    const auto ratios = [&](auto seconds) {
        Json out = Json::object();
        for (const Run_record& a : comparison.runs)
            for (const Run_record& b : comparison.runs)
                if (&a != &b) {
                    Json& ratio = out[a.strategy + "/" + b.strategy];
                    if (seconds(b) > 0) ratio = seconds(a) / seconds(b);
                }
        return out;
    };
    json["ratios"] = ratios([](const Run_record& run) { return run.seconds.triangulation; });
    json["ratios_of_medians"] = ratios(median_step);
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
    if (run.mesh_before)
        table.header.insert(table.header.end(), {"failures", "updates_per_failure", "mesh_vertices", "boundary",
                                                 "locked", "kept", "cells", "slivers", "dihedral_min", "dihedral_max"});
    table.rows.reserve(run.steps.size());
    for (const Iteration_record& s : run.steps) {
        table.rows.push_back({s.iteration,
                              s.seconds_triangulation,
                              s.seconds_motion,
                              s.seconds_cumulative,
                              s.displacement_mean,
                              s.displacement_max,
                              cell(s.tolerance_mean),
                              cell(s.annulus_width_mean),
                              cell(s.theta_min),
                              s.moves.asked,
                              s.moves.within_tolerance,
                              s.moves.kept_in_place,
                              s.moves.flipped,
                              s.moves.reinserted,
                              s.moves.rebuilt,
                              s.arithmetic.filter,
                              s.arithmetic.interval,
                              s.arithmetic.exact,
                              s.certificates_evaluated,
                              counts_flips(run) ? Csv_cell(s.flips) : Csv_cell()});
        if (run.mesh_before) append_mesh(table.rows.back(), s);
    }
    return table;
}

Csv_table dihedral_table(const Run_record& run) {
    Csv_table table;
    table.header = {"iteration"};
    for (int i = 0; i < 36; ++i) table.header.push_back(std::to_string(5 * i) + "-" + std::to_string(5 * i + 5));
    const auto append = [&](std::uint64_t iteration, const std::optional<Mesh_step>& mesh) {
        if (!mesh) return;
        table.rows.push_back({iteration});
        for (const std::uint64_t n : mesh->dihedral) table.rows.back().push_back(n);
    };
    append(0, run.mesh_before);
    for (const Iteration_record& s : run.steps) append(s.iteration, s.mesh);
    return table;
}

}  // namespace annulus::inline v1
