// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/page.h>

#include <apps/report/coinciding_curves.h>
#include <apps/report/report_style.h>
#include <apps/report/table.h>

#include <algorithm>
#include <cmath>
#include <optional>

namespace annulus::inline v1 {

namespace {

/// "iteration 3", or of an axis that counts "frames after the first" "3 frames after the first".
std::string at_place(const std::string& axis, double place) {
    if (axis == "finish") return "the finish";  // of nodt, without iterations
    const std::string number = readable(place);
    if (!axis.starts_with("frames ")) return axis.substr(0, axis.find(',')) + " " + number;
    return number + (place == 1 ? " frame " : " frames ") + axis.substr(axis.find(' ') + 1);
}

/// The x of all points of the curves of a plot, if it is one, and no bar.
std::optional<double> only_place(const Plot& plot) {
    std::optional<double> place;
    for (const Series& s : plot.series)
        for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
            if (!std::isfinite(s.x[i]) || !std::isfinite(s.y[i])) continue;
            if (s.steps || (place && *place != s.x[i])) return std::nullopt;
            place = s.x[i];
        }
    return place;
}

}  // namespace

std::string page_head(const std::string& title, const std::string& command) {
    std::string out =
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>";
    out += escaped(title) + "</title>\n<style>" + report_style + "</style>\n</head>\n<body>\n<main>\n<h1>" +
           escaped(title) + "</h1>\n";
    if (!command.empty()) out += "<p class=\"command\"><code>" + escaped(command) + "</code></p>\n";
    return out;
}

std::string page_foot() { return "</main>\n" + table_script() + "</body>\n</html>\n"; }

std::string percentage(std::uint64_t part, std::uint64_t all) {
    if (all == 0) return "–";
    const double value = 100 * static_cast<double>(part) / static_cast<double>(all);
    if (part != all && value >= 99.95) return "&gt; 99.9 %";
    if (part != 0 && value < 0.01) return "&lt; 0.01 %";
    return readable(value) + " %";
}

std::string duration(double seconds) {
    if (seconds == 0) return "0 s";
    if (seconds < 1e-3) return readable(seconds * 1e6) + " µs";
    return seconds < 1 ? readable(seconds * 1e3) + " ms" : readable(seconds) + " s";
}

void append_row(std::string& out, std::string_view name, const std::string& value) {
    out += "<tr><th scope=\"row\">" + escaped(name) + "</th><td>" + value + "</td></tr>\n";
}

void append_box(std::string& out, const std::string& from, const std::vector<std::vector<double>>& vectors,
                std::string_view when) {
    if (!vectors.empty()) append_row(out, "periodic box from", escaped(from));
    for (std::size_t i = 0; i < vectors.size(); ++i) {
        std::string text;
        for (const double c : vectors[i]) text += (text.empty() ? "" : ", ") + readable(c);
        append_row(out, "its vector " + std::to_string(i + 1) + std::string(when), text);
    }
}

std::string with_share(std::uint64_t part, std::uint64_t all) {
    return grouped(part) + " <small>(" + percentage(part, all) + ")</small>";
}

void append_figure(std::string& out, const std::string& heading, const std::string& svg, const std::string& caption) {
    out += "<figure>";
    if (!heading.empty()) out += "<h3>" + escaped(heading) + "</h3>";
    out += svg;
    if (!caption.empty()) out += "<figcaption>" + caption + "</figcaption>";
    out += "</figure>\n";
}

std::string plot_html(const Plot& plot) {
    const std::optional<double> place = only_place(plot);
    if (!place) return svg_plot(plot);
    std::string text = plot.y.label + ", " + at_place(plot.x.label, *place) + ":", separator = " ";
    if (text[0] >= 'a' && text[0] <= 'z') text[0] = static_cast<char>(text[0] - 'a' + 'A');
    for (const Series& s : plot.series)
        for (std::size_t i = 0; i < std::min(s.x.size(), s.y.size()); ++i) {
            if (!std::isfinite(s.x[i]) || !std::isfinite(s.y[i])) continue;
            text += separator + (s.name.empty() ? "" : s.name + " ") + readable(s.y[i]);
            if (i < s.error.size() && s.error[i] > 0) text += " ± " + readable(s.error[i]);
            separator = ", ";
        }
    return "<p>" + escaped(text) + ".</p>";
}

void append_plots(std::string& out, const std::string& heading, const std::vector<Plot>& plots,
                  const std::string& caption) {
    if (plots.empty()) return;
    out += "<h2>" + escaped(heading) + "</h2>\n<div class=\"panels\">\n";
    for (const Plot& plot : plots)
        append_figure(out, plot.title, plot_html(plot), only_place(plot) ? "" : escaped(on_coinciding_curves(plot)));
    out += "</div>\n";
    if (!caption.empty()) out += "<figcaption>" + escaped(caption) + "</figcaption>\n";
}

void append_warnings(std::string& out, const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings) out += "<p class=\"verdict bad\">" + escaped(warning) + "</p>\n";
}

void append_findings(std::string& out, const std::vector<std::string>& findings) {
    for (const std::string& finding : findings) out += "<p class=\"finding\">" + escaped(finding) + "</p>\n";
}

std::string listed(const std::vector<std::pair<std::string, std::string>>& columns) {
    std::string text;
    for (const auto& [what, where] : columns) text += (text.empty() ? "" : ", ") + what + ": " + where;
    return text;
}

void append_notes(std::string& out, const std::vector<std::string>& notes) {
    if (!notes.empty()) out += "<h2>Notes</h2>\n";
    for (const std::string& note : notes) out += "<p>" + escaped(note) + "</p>\n";
}

}  // namespace annulus::inline v1
