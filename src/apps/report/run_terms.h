// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/report.h>

#include <string>

// What the words on the page of a run mean.
namespace annulus::inline v1 {

/// The unit of length: "the square root of the area of the domain per vertex".
[[nodiscard]] std::string mean_spacing_of(const Run_record& run);

/// What the legend of Voronoi cells calls the white ones, which are not counted; empty in a periodic box.
[[nodiscard]] const char* white_cells(const Run_record& run);
/// Which vertices are inner ones, and which triangles are measured: sentences, below the picture of Voronoi cells.
[[nodiscard]] std::string cells_caption(const Run_record& run);

/// A heading and a list, HTML, for the end of the page.
void append_run_terms(std::string& out, const Report& report);

}  // namespace annulus::inline v1
