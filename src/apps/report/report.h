// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/film.h>
#include <apps/report/run_record.h>
#include <apps/report/svg_plot.h>
#include <apps/report/svg_triangulation.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The distribution of the standard annulus widths at one iteration, in mean spacings.
struct Width_distribution {
    std::uint64_t iteration = 0;
    Histogram widths;
};

/// A figure composed by the caller: panels side by side under one heading.
struct Figure {
    std::string heading;
    std::vector<Plot> panels;
    std::string caption;
};

/// A picture composed by the caller: an SVG element.
struct Drawing {
    std::string heading;
    std::string svg;
    std::string caption;  ///< HTML
};

/// The content of one report. Absent or empty members are left out of the page.
struct Report {
    std::string title;
    Run_record run;  ///< of `compare`: the run whose steps and pictures are shown
    std::optional<Picture> before;
    std::optional<Picture> after;
    Film film;                      ///< in place of before and after, if any
    std::vector<Picture> voronoi;   ///< Voronoi cells with their colours, of the first and of the last step
    std::vector<Drawing> drawings;  ///< side by side, the first pictures of the page
    std::vector<Width_distribution> annulus_widths;
    std::optional<Comparison_record> comparison;
    std::vector<Figure> figures;
    std::vector<std::string> notes;  ///< paragraphs at the end
};

/// The report as one self-contained HTML file: no network, no other file; a script only for the slider of a film.
/// It begins with what the run found; the numbers of the run are at its end. Linear in its content.
[[nodiscard]] std::string report_html(const Report& report);

}  // namespace annulus::inline v1
