// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/sweep_files.h>

#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/page.h>
#include <apps/report/table.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace annulus::inline v1 {

namespace {

constexpr std::array stage_names{"filter", "interval", "exact"};
constexpr std::size_t most_curves = 8;

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

/// Percentage of the samples below each edge.
Series cumulative(std::string name, const Bins& bins, const Histogram& scale) {
    std::uint64_t total = bins.below + bins.above;
    for (const std::uint64_t n : bins.in) total += n;
    Series s{std::move(name), {}, {}};
    std::uint64_t below = bins.below;
    for (std::size_t i = 0; i <= bins.in.size() && total > 0; ++i) {
        if (i > 0) below += bins.in[i - 1];
        if (below == 0) continue;
        s.x.push_back(scale.edges()[i]);
        s.y.push_back(100 * static_cast<double>(below) / static_cast<double>(total));
        if (below == total) break;
    }
    return s;
}

/// The percentage of the certificates in each bin that a stage decided.
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
        if (all == 0) continue;
        s.x.push_back(std::sqrt(edges.edges()[i] * edges.edges()[i + 1]));
        s.y.push_back(100 * static_cast<double>(part) / static_cast<double>(all));
    }
    return s;
}

Plot stages_plot(std::string title, std::string x, const Tally& t, const std::string& name) {
    Plot plot{std::move(title), {std::move(x), Scale::log10}, {"share, percent", Scale::linear, 0., 100.}, {}};
    for (const char* stage : stage_names) plot.series.push_back(share_of_stage(t, name, stage));
    return plot;
}

void append_widths(std::string& out, const std::vector<Grid_point>& points) {
    std::vector<Plot> plots;
    for (const auto& [name, title, x] :
         {std::array{"bicells.width", "Widths of bi-cells", "width (mean spacings)"},
          std::array{"tolerance.certified", "Certified tolerances of vertices", "tolerance (mean spacings)"},
          std::array{"tolerance.paper_over_exact", "The paper's tolerance over the exact one", "ratio"}}) {
        const bool ratio = std::string_view(x) == "ratio";  // few of them are below 1
        Plot plot{title, {x, Scale::log10}, {"share below, percent", ratio ? Scale::linear : Scale::log10}, {}};
        for (std::size_t i = 0; i < std::min(points.size(), most_curves); ++i) {
            const auto found = points[i].tally.histograms.find(name);
            if (found != points[i].tally.histograms.end())
                plot.series.push_back(cumulative(std::to_string(i + 1), found->second, scale(name)));
        }
        if (ratio) {  // at least a decade, or there are no ticks
            const auto beyond = [](const Series& of) { return !of.x.empty() && of.x.back() > 10; };
            plot.x.lower = 0.1;
            if (std::none_of(plot.series.begin(), plot.series.end(), beyond)) plot.x.upper = 10;
        }
        plots.push_back(std::move(plot));
    }
    append_plots(out, "Distributions", plots,
                 points.size() <= most_curves ? "By rows of the table. Where a curve begins with a horizontal line, "
                                                "its share is below the scale, or exactly 0."
                                              : "The first " + std::to_string(most_curves) +
                                                    " rows of the table, by their numbers; sums.json has all.");
}

}  // namespace

std::string sweep_html(const Spec& spec, const std::vector<Grid_point>& points) {
    std::string out = page_head(spec.title, "");
    append_warnings(out, ignored_boxes(points));
    out += "<div class=\"numbers\"><table>\n";
    Tally all;
    for (const Grid_point& point : points) all += point.tally;
    append_row(out, "experiments", grouped(count(all, "experiments")));
    append_row(out, "vertices", grouped(count(all, "vertices")));
    append_row(out, "bi-cells", grouped(count(all, "bicells.total")));
    append_row(out, "seed", std::to_string(spec.seed));
    out += "</table></div>\n<h2>What was found</h2>\n";
    std::vector<Table_row> rows;
    for (const Grid_point& point : points) rows.push_back(row_of(point, rows.size() + 1));
    append_table(
        out,
        {"grid point", "experiments", "bi-cells a vertex", "exactly 0", "width &lt; 1e-9", "&lt; 1e-3", "least width",
         "by intervals", "by integers", "not convex", "paper above exact", "paper unsound", "flat"},
        rows, true);
    out +=
        "<figcaption>Each row adds the experiments that differ in their seed only. Widths in mean spacings; shares of "
        "bi-cells, in the last columns of vertices. Flat: experiments whose points do not span the space, of which "
        "nothing is counted.</figcaption>\n";
    append_widths(out, points);
    append_plots(out, "Which arithmetic decides",
                 {stages_plot("Bi-cells by theta", "theta (radians)", all, "theta_log"),
                  stages_plot("Bi-cells by width", "width (ulps of the largest coordinate)", all, "bicells.width_ulps"),
                  stages_plot("Cells by width", "width (ulps of the largest coordinate)", all, "cells.width_ulps")},
                 "Of the certificates of all experiments in a bin, how many each stage decided. What is exactly "
                 "degenerate has no place on a scale of widths.");
    return out + page_foot();
}

}  // namespace annulus::inline v1
