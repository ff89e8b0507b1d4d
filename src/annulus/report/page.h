// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/report/svg_plot.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The parts of which every HTML page of the tool is made. What is called HTML is taken as it is, all other text is
// escaped.
namespace annulus {

/// Everything before the content: head, style sheet, title and the command, if there is one.
[[nodiscard]] std::string page_head(const std::string& title, const std::string& command);
/// The end, with the script of tables that can be sorted.
[[nodiscard]] std::string page_foot();

/// "12.3 %"; a share that is not all never reads as 100 %, and one that is not nothing never as 0 %. HTML.
[[nodiscard]] std::string percentage(std::uint64_t part, std::uint64_t all);
/// "1,234 (12.3 %)". HTML.
[[nodiscard]] std::string with_share(std::uint64_t part, std::uint64_t all);
[[nodiscard]] std::string duration(double seconds);

/// A row of two columns; `value` is HTML.
void append_row(std::string& out, std::string_view name, const std::string& value);
/// `caption` is HTML.
void append_figure(std::string& out, const std::string& heading, const std::string& svg, const std::string& caption);
/// Plots side by side under a heading; nothing where there are none.
void append_plots(std::string& out, const std::string& heading, const std::vector<Plot>& plots,
                  const std::string& caption);
/// Paragraphs under "Notes"; nothing where there are none.
/// What a reader has to know before all else, for the head of a page.
void append_warnings(std::string& out, const std::vector<std::string>& warnings);

/// "x: column 1, y: column 2".
[[nodiscard]] std::string listed(const std::vector<std::pair<std::string, std::string>>& columns);

void append_notes(std::string& out, const std::vector<std::string>& notes);

}  // namespace annulus
