// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/svg_plot.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The parts of every HTML page of the tool. Parameters called HTML are inserted unchanged, all other text is escaped.
namespace annulus::inline v1 {

/// Everything before the content: head, style sheet, title and the command, if there is one.
[[nodiscard]] std::string page_head(const std::string& title, const std::string& command);
/// The end, with the script for sortable tables.
[[nodiscard]] std::string page_foot();

/// "12.3 %"; a share below 1 is never shown as 100 %, and a share above 0 never as 0 %. HTML.
[[nodiscard]] std::string percentage(std::uint64_t part, std::uint64_t all);
/// "1,234 (12.3 %)". HTML.
[[nodiscard]] std::string with_share(std::uint64_t part, std::uint64_t all);
[[nodiscard]] std::string duration(double seconds);

/// A row of two columns; `value` is HTML.
void append_row(std::string& out, std::string_view name, const std::string& value);
/// Rows for a periodic box, none where it has no vectors: what gives it, and its vectors, each with its name, and then
/// `when`: nine numbers are too wide for a row.
void append_box(std::string& out, const std::string& from, const std::vector<std::vector<double>>& vectors,
                std::string_view when);
/// `caption` is HTML.
void append_figure(std::string& out, const std::string& heading, const std::string& svg, const std::string& caption);
/// The plot as SVG, or, where all its curves have one place, and the same, a sentence with their values. HTML.
[[nodiscard]] std::string plot_html(const Plot& plot);
/// Plots side by side under a heading; nothing where there are none.
void append_plots(std::string& out, const std::string& heading, const std::vector<Plot>& plots,
                  const std::string& caption);
/// The most important remarks, for the head of a page.
void append_warnings(std::string& out, const std::vector<std::string>& warnings);

/// What was found: paragraphs of text in larger letters, for the head of a page.
void append_findings(std::string& out, const std::vector<std::string>& findings);

/// "x: column 1, y: column 2".
[[nodiscard]] std::string listed(const std::vector<std::pair<std::string, std::string>>& columns);

/// Paragraphs under "Notes"; nothing where there are none.
void append_notes(std::string& out, const std::vector<std::string>& notes);

}  // namespace annulus::inline v1
