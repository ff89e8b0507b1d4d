// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/formats/write_csv.h>
#include <annulus/report/svg_plot.h>
#include <annulus/reproduction/reproduction.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace annulus {

/// A picture or a plot of a page, and the numbers behind it.
struct Panel {
    std::string heading;
    std::string svg;
    std::string caption{};           ///< plain text
    std::vector<std::string> csv{};  ///< names of the tables behind it
};

/// A page: one of the paper's figures, or what one of its claims is about.
struct Page_content {
    std::string name;  ///< "figure-7": of the file
    std::string title;
    std::string about;                                                   ///< what the paper shows there, in our words
    std::vector<std::pair<std::string, std::vector<Panel>>> sections{};  ///< by heading
    std::vector<std::string> notes{};
    std::vector<std::pair<std::string, Csv_table>> tables{};
};

/// Every page, in order; without sections where nothing was run for it.
[[nodiscard]] std::vector<Page_content> reproduction_pages(const Reproduction& reproduction);

/// Its parts: figures 5 to 7 and 8 to 12, and what is beside them.
void append_plane_pages(const Reproduction& reproduction, std::vector<Page_content>& out);
void append_mesh_pages(const Reproduction& reproduction, std::vector<Page_content>& out);
void append_cost_pages(const Reproduction& reproduction, std::vector<Page_content>& out);
[[nodiscard]] Page_content unsound_page(const Reproduction& reproduction);

/// "after 1,000 iterations, cut across x".
[[nodiscard]] std::string caption_of(const Picture_record& picture);

/// The plot as a panel, with its curves as a table of that name: a column for what is on the x axis and one for each
/// curve, a row for each x of any of them.
void append_plot(Page_content& page, std::vector<Panel>& panels, const Plot& plot, const std::string& csv,
                 std::string caption = "");

/// Mean displacement, width and tolerances along a race (figures 6a, 10a); how widths are distributed (6b, 10b).
[[nodiscard]] Plot convergence_plot(const Benchmark_record& benchmark);
[[nodiscard]] Plot width_plot(const Benchmark_record& benchmark);

}  // namespace annulus
