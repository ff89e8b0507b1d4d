// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/sweep_files.h>

#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/page.h>
#include <apps/report/table.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace annulus::inline v1 {

namespace {

constexpr std::array stage_names{"filter", "interval", "exact"};
constexpr std::size_t most_curves = 7;  // as many as there are colours

std::uint64_t count(const Tally& t, const std::string& name) {
    const auto found = t.counts.find(name);
    return found == t.counts.end() ? 0 : found->second;
}

/// A line for each file whose periodic box is ignored.
std::vector<std::string> ignored_boxes(const std::vector<Grid_point>& points) {
    std::vector<std::string> lines;
    for (const Grid_point& point : points) {
        if (!point.where.contains("ignored")) continue;
        std::string line = point.where["file"].get<std::string>() +
                           ": its periodic box is ignored: points are taken as they stand, with open boundaries";
        if (std::find(lines.begin(), lines.end(), line) == lines.end()) lines.push_back(std::move(line));
    }
    return lines;
}

/// "jittered, 3D, 1,000, decimal:3, walk 0.01, step 10", as text.
std::string label(const nlohmann::ordered_json& w) {
    std::string text = w.contains("file") ? w["file"].get<std::string>() : w["kind"].get<std::string>();
    text += ", " + std::to_string(w["dimension"].get<int>()) + "D, " + readable(w["points"].get<double>());
    if (w["rounding"] != "double") text += ", " + w["rounding"].get<std::string>();
    if (w.contains("motion")) text += ", " + w["motion"].get<std::string>();
    if (w.contains("pace")) text += " " + readable(w["pace"].get<double>());
    if (w.contains("motion")) text += ", step " + readable(w["step"].get<double>());
    if (w.contains("frame")) text += ", frame " + readable(w["frame"].get<double>());
    return text;
}

Table_cell share(std::uint64_t part, std::uint64_t all) {
    const double s = all == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(all);
    return {all == 0 ? "–" : part == 0 ? "0" : escaped(readable(100 * s)) + " %", s};
}

Table_row row_of(const Grid_point& point, std::size_t number) {
    const Tally& t = point.tally;
    const std::uint64_t bicells = count(t, "bicells.total"), vertices = count(t, "vertices");
    const auto least = t.least.find("bicells.width");
    Table_row row{{std::to_string(number) + " &nbsp;" + escaped(label(point.where)), static_cast<double>(number)},
                  {grouped(count(t, "experiments")), static_cast<double>(count(t, "experiments"))}};
    const double each = vertices == 0 ? 0.0 : static_cast<double>(bicells) / static_cast<double>(vertices);
    row.push_back({escaped(readable(each)), each});
    for (const char* name : {"bicells.zero", "bicells.below.1e-9", "bicells.below.1e-3"})
        row.push_back(share(count(t, name), bicells));
    if (least == t.least.end()) row.push_back("–");
    else row.push_back({escaped(readable(least->second)), least->second});
    for (const char* name : {"bicells.stage.interval", "bicells.stage.exact", "bicells.not_convex"})
        row.push_back(share(count(t, name), bicells));
    for (const char* name : {"tolerance.paper_above_exact", "tolerance.paper_unsound"})
        row.push_back(share(count(t, name), vertices));
    row.push_back({grouped(count(t, "flat")), static_cast<double>(count(t, "flat"))});
    return row;
}

/// Percentage of the samples below each edge, from the first bin with samples on.
Series cumulative(std::string name, const Bins& bins, const Histogram& scale) {
    std::uint64_t total = bins.below + bins.above;
    for (const std::uint64_t n : bins.in) total += n;
    Series s{std::move(name), {}, {}};
    if (bins.below == total) return s;  // all exactly 0
    std::uint64_t below = bins.below;
    for (std::size_t i = 0; i <= bins.in.size() && total > 0; ++i) {
        if (i > 0) below += bins.in[i - 1];
        const bool empty_before = i == 0 || below == bins.below;
        const bool empty_after = i < bins.in.size() && bins.in[i] == 0;
        if (below == 0 || (empty_before && empty_after && below < total)) continue;
        s.x.push_back(scale.edges()[i]);
        s.y.push_back(100 * static_cast<double>(below) / static_cast<double>(total));
        if (below == total) break;
    }
    return s;
}

/// The percentage of the certificates in each bin that a stage decided; a gap where a bin is empty.
Series share_of_stage(const Tally& t, const std::string& name, const char* stage) {
    const std::string whole_name = name + "." + stage;  // g++ 13 warns that the scale may refer to a temporary
    const Histogram& edges = scale(whole_name);
    Series s{stage, {}, {}};
    for (std::size_t i = 0; i + 1 < edges.edges().size(); ++i) {
        std::uint64_t all = 0, part = 0;
        for (const char* other : stage_names) {
            const auto found = t.histograms.find(name + "." + other);
            if (found == t.histograms.end()) return s;
            all += found->second.in[i];
            if (std::string_view(other) == stage) part = found->second.in[i];
        }
        s.x.push_back(std::sqrt(edges.edges()[i] * edges.edges()[i + 1]));
        s.y.push_back(all == 0 ? std::numeric_limits<double>::quiet_NaN()
                               : 100 * static_cast<double>(part) / static_cast<double>(all));
    }
    return s;
}

Plot stages_plot(std::string title, std::string x, const Tally& t, const std::string& name) {
    Plot plot{std::move(title), {std::move(x), Scale::log10}, {"share, percent", Scale::linear, 0., 100.}, {}};
    for (const char* stage : stage_names) plot.series.push_back(share_of_stage(t, name, stage));
    // The range is that of the bins with samples.
    for (const Series& s : plot.series)
        for (std::size_t i = 0; i < s.x.size(); ++i)
            if (!std::isnan(s.y[i])) {
                plot.x.lower = std::min(plot.x.lower.value_or(s.x[i]), s.x[i]);
                plot.x.upper = std::max(plot.x.upper.value_or(s.x[i]), s.x[i]);
            }
    return plot;
}

/// A row of the table, by its number from 1.
struct Row {
    std::size_t number;
    const Grid_point* point;
};

/// The parts of a row's label, in their order.
std::vector<std::string> parts_of(const Grid_point& point) {
    std::vector<std::string> parts;
    const std::string text = label(point.where);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(", ", begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 2;
    }
    return parts;
}

/// Names of curves: what a row's label has and not all others have. Its number, where that is nothing or too long.
std::vector<std::string> curve_names(const std::vector<Row>& rows) {
    constexpr std::size_t most = 24;
    std::vector<std::string> found;
    if (rows.size() == 1) return {""};
    for (const Row& row : rows) {
        std::string name;
        for (const std::string& part : parts_of(*row.point)) {
            const bool shared = std::all_of(rows.begin(), rows.end(), [&](const Row& other) {
                const auto parts = parts_of(*other.point);
                return std::find(parts.begin(), parts.end(), part) != parts.end();
            });
            if (!shared) name += (name.empty() ? "" : ", ") + part;
        }
        found.push_back(name.empty() || name.size() > most ? "row " + std::to_string(row.number) : name);
    }
    return found;
}

/// At most so many rows, spread over all.
std::vector<Row> some_of(const std::vector<Row>& rows) {
    if (rows.size() <= most_curves) return rows;
    std::vector<Row> some;
    for (std::size_t i = 0; i < most_curves; ++i) some.push_back(rows[i * (rows.size() - 1) / (most_curves - 1)]);
    return some;
}

void append_widths(std::string& out, const std::vector<Row>& all, const std::string& heading) {
    const std::vector<Row> rows = some_of(all);
    const std::vector<std::string> curves = curve_names(rows);
    std::vector<Plot> plots;
    for (const auto& [name, title, x] :
         {std::array{"bicells.width", "Widths of bi-cells", "width (mean spacings)"},
          std::array{"tolerance.certified", "Certified tolerances of vertices", "tolerance (mean spacings)"},
          std::array{"tolerance.paper_over_exact", "The paper's tolerance over the exact one", "ratio"}}) {
        const bool ratio = std::string_view(x) == "ratio";  // few of them are below 1
        Plot plot{title, {x, Scale::log10}, {"share below, percent", Scale::log10, {}, 100.}, {}};
        if (ratio) plot.y = {"share below, percent", Scale::linear, 0., 100.};
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto found = rows[i].point->tally.histograms.find(name);
            if (found != rows[i].point->tally.histograms.end())
                plot.series.push_back(cumulative(curves[i], found->second, scale(name)));
        }
        if (ratio) {  // at least a decade, or there are no ticks
            const auto beyond = [](const Series& of) { return !of.x.empty() && of.x.back() > 10; };
            plot.x.lower = 0.1;
            if (std::none_of(plot.series.begin(), plot.series.end(), beyond)) plot.x.upper = 10;
        }
        plots.push_back(std::move(plot));
    }
    std::string caption =
        "A curve begins where the samples on its scale begin, at the share of what is narrower or exactly 0; there "
        "is none where all are exactly 0.";
    if (rows.size() < all.size()) {
        caption += " Of " + std::to_string(all.size()) + " rows of the table these are shown:";
        for (const Row& row : rows) caption += " " + std::to_string(row.number);
        caption += "; sums.json has all.";
    }
    append_plots(out, heading, plots, caption);
}

/// "none", or the number.
std::string none_or(std::uint64_t n) { return n == 0 ? "none" : grouped(n); }

/// What the placements of one dimension have.
std::string finding(int dimension, const Tally& t) {
    const std::uint64_t zero = count(t, "bicells.zero"), narrow = count(t, "bicells.below.1e-9");
    std::string text = "In " + std::to_string(dimension) + "D " + none_or(zero) + " of " +
                       grouped(count(t, "bicells.total")) + " bi-cells " + (zero <= 1 ? "is" : "are") +
                       " exactly degenerate, and " + none_or(narrow) + (narrow <= 1 ? " is" : " are") +
                       " narrower than a billionth of a mean spacing";
    if (const auto least = t.least.find("bicells.width"); least != t.least.end())
        text += " (the least width is " + readable(least->second) + ")";
    return text + ". Integers had to decide " + none_or(count(t, "bicells.stage.exact")) +
           " of them. The paper's tolerance is unsound at " + none_or(count(t, "tolerance.paper_unsound")) + " of " +
           grouped(count(t, "vertices")) + " vertices.";
}

}  // namespace

std::string sweep_html(const Spec& spec, const std::vector<Grid_point>& points) {
    std::string out = page_head(spec.title, "");
    append_warnings(out, ignored_boxes(points));
    std::map<int, std::vector<Row>> of;  // by dimension
    std::map<int, Tally> sum;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const int dimension = points[i].where["dimension"].get<int>();
        of[dimension].push_back({i + 1, &points[i]});
        sum[dimension] += points[i].tally;
    }
    for (const auto& [dimension, tally] : sum) append_findings(out, {finding(dimension, tally)});
    out += "<h2>What was found</h2>\n";
    std::vector<Table_row> rows;
    for (const Grid_point& point : points) rows.push_back(row_of(point, rows.size() + 1));
    append_table(
        out,
        {"grid point", "placements", "bi-cells a vertex", "exactly 0", "width &lt; 1e-9", "&lt; 1e-3", "least width",
         "by intervals", "by integers", "not convex", "paper above exact", "paper unsound", "flat"},
        rows, true);
    out +=
        "<figcaption>Each row adds the placements that differ in their seed only. Widths in mean spacings; shares of "
        "bi-cells, in the last columns of vertices. Flat: placements whose points do not span the space, of which "
        "nothing is counted.</figcaption>\n";
    Tally all;
    for (const auto& [dimension, tally] : sum) {
        const std::string where = sum.size() > 1 ? " in " + std::to_string(dimension) + "D" : "";
        append_widths(out, of[dimension], "Distributions" + where);
        append_plots(
            out, "Which arithmetic decides" + where,
            {stages_plot("Bi-cells by theta", "theta (radians)", tally, "theta_log"),
             stages_plot("Bi-cells by width", "width (ulps of the largest coordinate)", tally, "bicells.width_ulps"),
             stages_plot("Cells by width", "width (ulps of the largest coordinate)", tally, "cells.width_ulps")},
            "Of the certificates in a bin, how many each stage decided; there is a gap where a bin is empty. What is "
            "exactly degenerate has no place on a scale of widths.");
        all += tally;
    }
    out += "<h2>The sweep in numbers</h2>\n<div class=\"numbers\"><table>\n";
    append_row(out, "trials", grouped(spec.trials.size()));
    append_row(out, "placements, of which a trial with a motion or frames has several",
               grouped(count(all, "experiments")));
    append_row(out, "vertices", grouped(count(all, "vertices")));
    append_row(out, "bi-cells", grouped(count(all, "bicells.total")));
    append_row(out, "seed", std::to_string(spec.seed));
    out += "</table></div>\n";
    return out + page_foot();
}

}  // namespace annulus::inline v1
