// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/write_csv.h>
#include <apps/report/svg_plot.h>
#include <apps/reproduction/reproduction.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// A picture or a plot of a page, and its data.
struct Panel {
    std::string heading;
    std::string svg;
    std::string caption{};           ///< plain text
    std::vector<std::string> csv{};  ///< names of its tables
    bool cut = false;                ///< a mesh, cut open, coloured by least dihedral angles
};

/// A page: one of the paper's figures, or the subject of one of its claims.
struct Page_content {
    std::string name;  ///< "figure-7": name of the file
    std::string title;
    std::string about;                                                   ///< the figure's content, in our words
    std::vector<std::pair<std::string, std::vector<Panel>>> sections{};  ///< by heading
    std::vector<std::string> notes{};
    std::vector<std::pair<std::string, Csv_table>> tables{};
};

/// All pages, in order; a page for which nothing was run has no sections.
[[nodiscard]] std::vector<Page_content> reproduction_pages(const Reproduction& reproduction);

/// Its parts: figures 5 to 7 and 8 to 12, and the other pages.
void append_plane_pages(const Reproduction& reproduction, std::vector<Page_content>& out);
void append_mesh_pages(const Reproduction& reproduction, std::vector<Page_content>& out);
void append_cost_pages(const Reproduction& reproduction, std::vector<Page_content>& out);
[[nodiscard]] Page_content unsound_page(const Reproduction& reproduction);

/// "after 1,000 iterations, cut at x = 0.5".
[[nodiscard]] std::string caption_of(const Picture_record& picture);

/// The plot as a panel, with its curves as a table of that name: a column for the x axis and one for each curve, a row
/// for each x of any of them.
void append_plot(Page_content& page, std::vector<Panel>& panels, const Plot& plot, const std::string& csv,
                 std::string caption = "");

/// Mean displacement, width and tolerances along a benchmark (figures 6a, 10a); the distribution of widths (6b, 10b).
[[nodiscard]] Plot convergence_plot(const Benchmark_record& benchmark);
[[nodiscard]] Plot width_plot(const Benchmark_record& benchmark);

}  // namespace annulus::inline v1
