// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/sweep_plots.h>

#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/cumulative_curve.h>
#include <apps/report/page.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <span>
#include <string_view>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr std::array stage_names{"filter", "interval", "exact"};
constexpr std::size_t most_curves = 7;  // as many as there are colours

std::uint64_t samples(const Bins& bins) {
    return std::accumulate(bins.in.begin(), bins.in.end(), bins.below + bins.above);
}

/// Straight in each bin; `least_share`: see cumulative_curve.h.
Series cumulative(std::string name, const Bins& bins, const Histogram& scale, double least_share) {
    return cumulative_curve(std::move(name), {scale.edges(), bins.in, bins.below, samples(bins)}, {}, least_share);
}

/// Whether a row has samples of this name: in periodic boxes there are none of the paper's tolerance.
bool have(const std::vector<Sweep_row>& rows, const std::string& name) {
    return std::any_of(rows.begin(), rows.end(),
                       [&](const Sweep_row& row) { return row.point->tally.histograms.contains(name); });
}

/// Whether all samples of the rows are in the two bins that meet at 1.
bool all_are_one(const std::vector<Sweep_row>& rows, const std::string& name) {
    const auto edges = scale(name).edges();
    const auto one = static_cast<std::size_t>(
        std::find_if(edges.begin(), edges.end(), [](double x) { return x > 1 - 1e-9; }) - edges.begin());
    return std::all_of(rows.begin(), rows.end(), [&](const Sweep_row& row) {
        const auto found = row.point->tally.histograms.find(name);
        return found == row.point->tally.histograms.end() ||
               found->second.in[one - 1] + found->second.in[one] == samples(found->second);
    });
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
    if (plot.x.lower && plot.x.lower == plot.x.upper)  // a sentence stands in its place
        plot.x.label = "one bin of " + plot.x.label + " around";
    return plot;
}

/// The parts of a row's label, in their order.
std::vector<std::string> parts_of(const Grid_point& point) {
    std::vector<std::string> parts;
    const std::string text = label_of(point.where);
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(", ", begin), text.size());
        parts.push_back(text.substr(begin, end - begin));
        begin = end + 2;
    }
    return parts;
}

bool has(const Sweep_row& row, const std::string& part) {
    const std::vector<std::string> parts = parts_of(*row.point);
    return std::find(parts.begin(), parts.end(), part) != parts.end();
}

/// Whether no other row has all of these parts.
bool is_name_of(const Sweep_row& row, const std::vector<Sweep_row>& rows, std::span<const std::string> parts) {
    return std::none_of(rows.begin(), rows.end(), [&](const Sweep_row& other) {
        return other.number != row.number &&
               std::all_of(parts.begin(), parts.end(), [&](const std::string& part) { return has(other, part); });
    });
}

std::string joined(std::span<const std::string> parts) {
    std::string text;
    for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
    return text;
}

/// Names of curves of some rows: what a row's label has and not those of all rows have. Where that is too long the
/// first parts are left out, if no other row has all that remain. A row's number, where there is no such name.
std::vector<std::string> curve_names(const std::vector<Sweep_row>& rows, const std::vector<Sweep_row>& all) {
    constexpr std::size_t most = 24;
    std::vector<std::string> found;
    if (all.size() == 1) return {""};
    for (const Sweep_row& row : rows) {
        std::vector<std::string> parts = parts_of(*row.point);
        std::erase_if(parts, [&](const std::string& part) {
            return std::all_of(all.begin(), all.end(), [&](const Sweep_row& any) { return has(any, part); });
        });
        std::span<const std::string> name = parts;
        while (!name.empty() && joined(name).size() > most) name = name.subspan(1);
        const bool whole = name.size() == parts.size();
        const bool says = !name.empty() && (whole || is_name_of(row, all, name));
        found.push_back(says ? joined(name) : "row " + std::to_string(row.number));
    }
    return found;
}

/// At most so many rows, spread over all.
std::vector<Sweep_row> some_of(const std::vector<Sweep_row>& rows) {
    if (rows.size() <= most_curves) return rows;
    std::vector<Sweep_row> some;
    for (std::size_t i = 0; i < most_curves; ++i) some.push_back(rows[i * (rows.size() - 1) / (most_curves - 1)]);
    return some;
}

/// "box 2 × 1", "box (1 0) (0.5 1)", as text.
std::string box_label(const nlohmann::ordered_json& vectors) {
    std::string lengths, rows;
    bool upright = true;
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        rows += " (";
        for (std::size_t k = 0; k < vectors.size(); ++k) {
            const double x = vectors[i][k].get<double>();
            rows += (k > 0 ? " " : "") + readable(x);
            upright = upright && (i == k || x == 0);
            if (i == k) lengths += (i > 0 ? " × " : " ") + readable(x);
        }
        rows += ")";
    }
    return "box" + (upright ? lengths : rows);
}

/// Whether intervals or integers had to decide certificates of this kind.
bool beyond_filter(const Tally& t, const std::string& kind) {
    return count(t, kind + ".stage.interval") + count(t, kind + ".stage.exact") > 0;
}

}  // namespace

std::string label_of(const nlohmann::ordered_json& w) {
    std::string text = w.contains("file") ? w["file"].get<std::string>() : w["kind"].get<std::string>();
    text += ", " + std::to_string(w["dimension"].get<int>()) + "D, " + readable(w["points"].get<double>());
    if (w.contains("box")) text += ", " + box_label(w["box"]);
    if (w["rounding"] != "double") text += ", " + w["rounding"].get<std::string>();
    if (w.contains("motion")) text += ", " + w["motion"].get<std::string>();
    if (w.contains("pace")) text += " " + readable(w["pace"].get<double>());
    if (w.contains("motion")) text += ", step " + readable(w["step"].get<double>());
    if (w.contains("frame")) text += ", frame " + readable(w["frame"].get<double>());
    return text;
}

void append_distributions(std::string& out, const std::vector<Sweep_row>& all, const std::string& heading) {
    const std::vector<Sweep_row> rows = some_of(all);
    const std::vector<std::string> curves = curve_names(rows, all);
    std::vector<Plot> plots;
    std::string caption =
        "A curve begins where the samples on its scale begin, at the share of what is narrower or exactly 0; there is "
        "none where all are exactly 0. Within a bin of the scale it is straight.";
    for (const auto& [name, title, x] :
         {std::array{"bicells.width", "Widths of bi-cells", "width (mean spacings)"},
          std::array{"tolerance.certified", "Certified tolerances of vertices", "tolerance (mean spacings)"},
          std::array{"tolerance.paper_over_exact", "The paper's tolerance over the exact one", "ratio"}}) {
        const bool ratio = std::string_view(x) == "ratio";  // few of them are below 1
        if (!have(all, name)) continue;
        if (ratio && all_are_one(all, name)) {
            caption += " The paper's tolerance is the exact one at all vertices, up to 6 %, the width of a bin.";
            continue;
        }
        Plot plot{title, {x, Scale::log10}, {"share below, percent", Scale::log10, {}, 100.}, {}};
        if (ratio) plot.y = {"share below, percent", Scale::linear, 0., 100.};
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const auto found = rows[i].point->tally.histograms.find(name);
            // A row without samples keeps its place, so that the colours of the others are the same in all plots.
            plot.series.emplace_back();
            if (found == rows[i].point->tally.histograms.end()) continue;
            const double least = ratio ? 0 : 100 / static_cast<double>(samples(found->second));
            plot.series.back() = cumulative(curves[i], found->second, scale(name), least);
        }
        if (std::all_of(plot.series.begin(), plot.series.end(), [](const Series& s) { return s.x.empty(); })) continue;
        give_room(plot);
        plots.push_back(std::move(plot));
    }
    if (rows.size() < all.size()) {
        caption += " There is room for " + grouped(rows.size()) + " of " + grouped(all.size()) +
                   " rows of the table; spread evenly over it, these are shown:";
        for (const Sweep_row& row : rows) caption += " " + std::to_string(row.number);
        caption +=
            "; sums.json has all. A curve is named by what its row has and not all rows have, without the first of it "
            "where no other row has the rest, or by its number.";
    }
    append_plots(out, heading, plots, caption);
}

void append_stages(std::string& out, const Tally& tally, const std::string& heading, bool periodic) {
    const char* const width =
        periodic ? "width (spacings of the grid of the box)" : "width (ulps of the largest coordinate)";
    std::vector<Plot> plots;
    std::string filter_alone;
    if (beyond_filter(tally, "bicells")) {
        plots.push_back(stages_plot("Bi-cells by theta", "theta (radians)", tally, "theta_log"));
        plots.push_back(stages_plot("Bi-cells by width", width, tally, "bicells.width_ulps"));
    } else {
        filter_alone += "The filter decided all " + grouped(count(tally, "bicells.total")) + " bi-cells. ";
    }
    if (beyond_filter(tally, "cells")) plots.push_back(stages_plot("Cells by width", width, tally, "cells.width_ulps"));
    else filter_alone += "The filter decided all " + grouped(count(tally, "cells.total")) + " cells. ";
    if (plots.empty()) out += "<h2>" + escaped(heading) + "</h2>\n<p>" + escaped(filter_alone) + "</p>\n";
    append_plots(out, heading, plots,
                 filter_alone +
                     "Of the certificates in a bin, how many each stage decided; there is a gap where a bin "
                     "is empty. What is exactly degenerate has no place on a scale of widths.");
}

}  // namespace annulus::inline v1
