// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/report/film.h>
#include <annulus/report/run_record.h>
#include <annulus/report/svg_plot.h>
#include <annulus/report/svg_triangulation.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus {

/// How the standard annulus widths were distributed at one iteration, in mean spacings.
struct Width_distribution {
    std::uint64_t iteration = 0;
    Histogram widths;
};

/// A figure that the caller composes: panels side by side under one heading.
struct Figure {
    std::string heading;
    std::vector<Plot> panels;
    std::string caption;
};

/// Everything one report shows. What is absent or empty is left out of the page.
struct Report {
    std::string title;
    Run_record run;  ///< of `compare`: the run whose steps and pictures are shown
    std::optional<Picture> before;
    std::optional<Picture> after;
    Film film;  ///< in place of before and after, where there is one
    std::vector<Width_distribution> annulus_widths;
    std::optional<Comparison_record> comparison;
    std::vector<Figure> figures;
    std::vector<std::string> notes;  ///< paragraphs at the end
};

/// The report as one HTML file that needs nothing else: no network, no other file; a script for the slider of a film
/// only. Linear in its content.
[[nodiscard]] std::string report_html(const Report& report);

}  // namespace annulus
