// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/certificate_survey.h>

namespace annulus::inline v1 {

/// The errors of the paper's half widths in plain double for every finite bi-cell of `dt`, a paper_triangulation,
/// computed with exact integers. The paper expects their stability to be proportional to theta. A few microseconds per
/// bi-cell.
template <int d>
[[nodiscard]] Stability_record measure_stability(const Moving_of<d>& dt);

extern template Stability_record measure_stability<2>(const Moving_delaunay_2&);
extern template Stability_record measure_stability<3>(const Moving_delaunay_3&);

}  // namespace annulus::inline v1
