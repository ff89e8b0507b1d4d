// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/reproduction/certificate_survey.h>

namespace annulus {

/// How far the paper's half widths in plain double are from the exact ones, for every finite bi-cell of `dt`, a
/// paper_triangulation: exact integers say so. The paper expects their stability to be proportional to theta. Some
/// microseconds a bi-cell.
template <int d>
[[nodiscard]] Stability_record measure_stability(const Moving_of<d>& dt);

extern template Stability_record measure_stability<2>(const Moving_delaunay_2&);
extern template Stability_record measure_stability<3>(const Moving_delaunay_3&);

}  // namespace annulus
