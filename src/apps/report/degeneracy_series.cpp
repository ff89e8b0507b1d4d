// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/version.h>
#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/certificate_terms.h>
#include <apps/report/degeneracy_series.h>
#include <apps/report/page.h>
#include <apps/report/summary.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr std::array<std::size_t, 3> shown{0, 2, 5};  // of Distribution::probabilities
static_assert(Distribution::probabilities[2] == 0.01 && Distribution::probabilities[5] == 0.5);
constexpr std::array<const char*, 3> shown_names{"min", "1%", "median"};  // in tables
constexpr std::array<const char*, 3> curve_names{"least", "1 %", "median"};

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

/// How many bi-cells are degenerate in the frames, where the narrowest annulus is, how tolerances have changed, and
/// where that of the paper is unsound, which is computed without a box only. Nothing where all frames are flat.
std::vector<std::string> findings(const Degeneracy_series& series) {
    std::vector<const Degeneracy_row*> rows;
    for (const Degeneracy_row& row : series.rows)
        if (row.numbers) rows.push_back(&row);
    if (rows.empty()) return {};
    const auto by = [&](auto value) {
        return [value](const Degeneracy_row* a, const Degeneracy_row* b) {
            return value(*a->numbers) < value(*b->numbers);
        };
    };
    using Numbers = Degeneracy_row::Numbers;
    std::uint64_t bicells = 0, zero = 0, degenerate_frames = 0;
    for (const Degeneracy_row* row : rows) {
        bicells += row->numbers->bicells;
        zero += row->numbers->zero;
        degenerate_frames += row->numbers->zero > 0 ? 1 : 0;
    }
    const std::string frames = grouped(rows.size()) + (rows.size() == 1 ? " frame" : " frames");
    std::string text = (zero == 0 ? "None" : grouped(zero)) + " of the " + grouped(bicells) + " bi-cells of " + frames +
                       (zero > 1 ? " are" : " is") + " exactly degenerate";
    if (zero > 0) text += ", in " + grouped(degenerate_frames) + " of them";
    if (zero == 0) {
        const auto narrow = std::min_element(rows.begin(), rows.end(), by([](const Numbers& n) { return n.width[0]; }));
        text += ": the narrowest annulus is " + readable((*narrow)->numbers->width[0]) +
                " mean spacings wide, in frame " + grouped((*narrow)->frame);
    }
    const double first = rows.front()->numbers->tolerance[2], last = rows.back()->numbers->tolerance[2];
    text += ". The median certified tolerance ";
    text += readable(first) == readable(last)
                ? "is " + readable(last) + " mean spacings in the first frame and the last"
                : (last > first ? "rose from " : "fell from ") + readable(first) + " to " + readable(last) +
                      " mean spacings from the first frame to the last";
    if (rows.front()->numbers->periodic) return {text + "."};
    const auto unsound =
        std::max_element(rows.begin(), rows.end(), by([](const Numbers& n) { return n.paper_unsound; }));
    const std::uint64_t most = (*unsound)->numbers->paper_unsound;
    return {text + (most == 0 ? ". The paper's tolerance is sound at all vertices."
                              : ". The paper's tolerance is unsound at " + grouped(most) +
                                    (most == 1 ? " vertex" : " vertices") + " at most, in frame " +
                                    grouped((*unsound)->frame) + ".")};
}

/// Whether a curve has no other value.
bool only_zero(const Series& s) {
    return std::all_of(s.y.begin(), s.y.end(), [](double y) { return y == 0; });
}

Axis frame_axis() { return {"frame", Scale::linear, {}, {}, true}; }

/// Counts over the frames. What is 0 in all frames is a sentence.
void append_frame_counts(std::string& out, const Degeneracy_series& series) {
    using Numbers = Degeneracy_row::Numbers;
    std::vector<Plot> plots;
    std::string none;
    const auto add = [&](Plot&& plot, const std::string& sentence) {
        std::erase_if(plot.series, only_zero);
        if (plot.series.empty()) none += sentence;
        else plots.push_back(std::move(plot));
    };
    const auto plot_of = [](std::string title, std::string counted) {
        return Plot{std::move(title), frame_axis(), {std::move(counted), Scale::linear, 0., {}, false}, {}};
    };
    Plot narrow = plot_of("Bi-cells narrower than a threshold", "bi-cells");
    for (std::size_t k = 0; k < series.thresholds.size(); ++k)
        narrow.series.push_back(over_frames(series.thresholds[k] == "ulp" ? "1 ulp" : series.thresholds[k], series,
                                            [k](const Numbers& n) { return n.below[k]; }));
    add(std::move(narrow), " No bi-cell of any frame is narrower than any of the thresholds.");
    Plot degenerate = plot_of("Bi-cells that are exactly degenerate", "bi-cells");
    degenerate.series = {over_frames("", series, [](const Numbers& n) { return n.zero; })};
    add(std::move(degenerate), " No bi-cell of any frame is exactly degenerate.");
    if (series.input.box.empty()) {  // else it is not computed
        Plot unsound = plot_of("Vertices at which the paper's tolerance is unsound", "vertices");
        unsound.series = {over_frames("", series, [](const Numbers& n) { return n.paper_unsound; })};
        add(std::move(unsound), " The paper's tolerance is sound at all vertices of all frames.");
    }
    const std::string caption =
        "Every count is certified. Thresholds are in mean spacings of the frame; one that no "
        "bi-cell is below has no curve." +
        none + " degeneracy.csv has the numbers.";
    if (plots.empty()) out += "<h2>Counts</h2>\n<p>" + escaped(caption) + "</p>\n";
    append_plots(out, "Counts", plots, caption);
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
                   d.theta.quantiles.empty() ? 0 : d.theta.quantiles[5],
                   d.periodic};
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
            for (const auto* values : {&n.width, &n.tolerance, &n.paper}) {
                if (n.periodic && values == &n.paper) cells.resize(cells.size() + values->size());
                else cells.insert(cells.end(), values->begin(), values->end());
            }
            if (n.periodic) cells.emplace_back();
            else cells.emplace_back(n.paper_unsound);
            cells.insert(cells.end(), {n.non_convex, n.theta_median});
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
    const auto lengths = [&](std::string title, std::array<double, 3> Numbers::*of) {
        Plot plot{std::move(title), frame_axis(), {"mean spacings", Scale::log10, {}, {}, false}, {}};
        for (std::size_t k = 0; k < shown.size(); ++k)
            plot.series.push_back(over_frames(curve_names[k], series, [=](const Numbers& n) { return (n.*of)[k]; }));
        return plot;
    };
    std::string out = page_head(series.file + ": " + grouped(series.rows.size()) +
                                    (series.rows.size() == 1 ? " frame" : " frames") + ", how degenerate",
                                series.command);
    append_warnings(out, series.input.warnings);
    append_findings(out, findings(series));
    const bool flat = std::none_of(series.rows.begin(), series.rows.end(),
                                   [](const Degeneracy_row& row) { return row.numbers.has_value(); });
    if (flat) out += "<p class=\"verdict\">The points of no frame span the space: there is nothing to measure.</p>\n";
    if (!series.input.columns.empty()) out += "<p>" + escaped(listed(series.input.columns)) + ".</p>\n";
    const bool periodic = !series.input.box.empty();
    if (periodic) {
        out += "<div class=\"numbers\"><table>\n";
        append_box(out, series.input.box_from, series.input.box, " at the end");
        out += "</table></div>\n";
    }
    std::vector<Plot> widths{lengths("Widths of bi-cells", &Numbers::width),
                             lengths("Certified tolerances of vertices", &Numbers::tolerance)};
    if (!periodic) widths.push_back(lengths("The paper's tolerances", &Numbers::paper));
    std::erase_if(widths,
                  [](const Plot& plot) { return std::all_of(plot.series.begin(), plot.series.end(), only_zero); });
    append_plots(out, "Widths and tolerances", widths,
                 "The least, the one that 1 % are below, and the median, in mean spacings of the frame. What is 0 is "
                 "not drawn, and what is 0 in all frames has no plot.");
    if (!flat) append_frame_counts(out, series);
    append_degeneracy_terms(out, {series.dimension == 2, series.dimension == 3, !periodic, periodic});
    return out + page_foot();
}

}  // namespace annulus::inline v1
