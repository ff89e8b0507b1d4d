// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/version.h>
#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/degeneracy_series.h>
#include <apps/report/page.h>
#include <apps/report/summary.h>

#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr std::array<std::size_t, 3> shown{0, 2, 5};  // of Distribution::probabilities
static_assert(Distribution::probabilities[2] == 0.01 && Distribution::probabilities[5] == 0.5);
constexpr std::array<const char*, 3> shown_names{"min", "1%", "median"};

std::array<double, 3> quantiles_of(const Distribution& d) {
    std::array<double, 3> out{};
    for (std::size_t k = 0; k < shown.size() && !d.quantiles.empty(); ++k) out[k] = d.quantiles[shown[k]];
    return out;
}

template <class Value>
Series over_frames(std::string name, const Degeneracy_series& series, Value value) {
    Series s{std::move(name), {}, {}};
    for (const Degeneracy_row& row : series.rows) {
        if (!row.numbers) continue;
        s.x.push_back(static_cast<double>(row.frame));
        s.y.push_back(static_cast<double>(value(*row.numbers)));
    }
    return s;
}

}  // namespace

Degeneracy_row degeneracy_row(std::uint64_t frame, const Degeneracy_record& record) {
    Degeneracy_row row{frame, record.points, record.vertices};
    if (!record.measured) return row;
    const Degeneracy& d = *record.measured;
    row.numbers = {d.spacing,
                   d.bicells.least.total,
                   d.bicells.least.zero,
                   d.non_convex,
                   d.vertices.paper_unsound,
                   d.bicells.least.below,
                   quantiles_of(d.bicells.least.width),
                   quantiles_of(d.vertices.certified),
                   quantiles_of(d.vertices.paper),
                   d.theta.quantiles.empty() ? 0 : d.theta.quantiles[5]};
    return row;
}

Csv_table degeneracy_table(const Degeneracy_series& series) {
    Csv_table table;
    table.header = {"frame", "points", "merged", "mean_spacing", "bicells", "zero"};
    for (const std::string& name : series.thresholds) table.header.push_back("below_" + name);
    for (const char* what : {"width_", "tolerance_", "paper_"})
        for (const char* name : shown_names) table.header.push_back(std::string(what) + name);
    for (const char* name : {"paper_unsound", "non_convex", "theta_median"}) table.header.emplace_back(name);
    for (const Degeneracy_row& row : series.rows) {
        auto& cells = table.rows.emplace_back();
        cells = {row.frame, row.points, row.points - row.vertices};
        if (row.numbers) {
            const Degeneracy_row::Numbers& n = *row.numbers;
            cells.insert(cells.end(), {n.spacing, n.bicells, n.zero});
            cells.insert(cells.end(), n.below.begin(), n.below.end());
            for (const auto* values : {&n.width, &n.tolerance, &n.paper})
                cells.insert(cells.end(), values->begin(), values->end());
            cells.insert(cells.end(), {n.paper_unsound, n.non_convex, n.theta_median});
        }
        cells.resize(table.header.size());
    }
    return table;
}

nlohmann::ordered_json degeneracy_json(const Degeneracy_series& series) {
    nlohmann::ordered_json json{{"command", series.command},    {"version", ANNULUS_VERSION_STRING},
                                {"file", series.file},          {"dimension", series.dimension},
                                {"frames", series.rows.size()}, {"thresholds", series.thresholds}};
    append_input(json, series.input);
    return json;
}

std::string degeneracy_html(const Degeneracy_series& series) {
    using Numbers = Degeneracy_row::Numbers;
    const Axis frames{"frame", Scale::linear, {}, {}, true};
    const auto lengths = [&](std::string title, std::array<double, 3> Numbers::*of) {
        Plot plot{std::move(title), frames, {"mean spacings", Scale::log10, {}, {}, false}, {}};
        for (std::size_t k = 0; k < shown.size(); ++k)
            plot.series.push_back(over_frames(shown_names[k], series, [=](const Numbers& n) { return (n.*of)[k]; }));
        return plot;
    };
    Plot counts{"Bi-cells with a width below", frames, {"bi-cells", Scale::log10, {}, {}, false}, {}};
    for (std::size_t k = 0; k < series.thresholds.size(); ++k)
        counts.series.push_back(
            over_frames(series.thresholds[k], series, [k](const Numbers& n) { return n.below[k]; }));
    Plot zero{"Bi-cells that are exactly degenerate", frames, {"bi-cells", Scale::linear, 0., {}, false}, {}};
    zero.series.push_back(over_frames("", series, [](const Numbers& n) { return n.zero; }));
    Plot unsound{
        "Vertices at which the paper's tolerance is unsound", frames, {"vertices", Scale::linear, 0., {}, false}, {}};
    unsound.series.push_back(over_frames("", series, [](const Numbers& n) { return n.paper_unsound; }));
    std::string out = page_head(series.file + ": " + grouped(series.rows.size()) +
                                    (series.rows.size() == 1 ? " frame" : " frames") + ", how degenerate",
                                series.command);
    append_warnings(out, series.input.warnings);
    if (!series.input.columns.empty()) out += "<p>" + escaped(listed(series.input.columns)) + ".</p>\n";
    append_plots(out, "Widths and tolerances",
                 {lengths("Widths of bi-cells", &Numbers::width),
                  lengths("Certified tolerances of vertices", &Numbers::tolerance),
                  lengths("The paper's tolerances", &Numbers::paper)},
                 "The least, the one that 1 % are below, and the median, in mean spacings of the frame. What is 0 is "
                 "not drawn.");
    append_plots(out, "Counts", {counts, zero, unsound},
                 "Every count is certified; where one is 0 the first of these has no line. degeneracy.csv has the "
                 "numbers.");
    return out + page_foot();
}

}  // namespace annulus::inline v1
