// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/report.h>

#include <vector>

namespace annulus::inline v1 {

/// Mean displacement, tolerance and standard annulus width over the iterations (figure 6a of the paper), then the
/// distributions of the width (figure 6b). Panels without data are left out.
[[nodiscard]] std::vector<Plot> convergence_plots(const Report& report);

/// Percentage of moves beyond the tolerance, and time per step, over the iterations.
[[nodiscard]] std::vector<Plot> cost_plots(const Run_record& run);

/// Dihedral angles before and after, slivers and share of locked vertices over the iterations. Empty without meshes.
[[nodiscard]] std::vector<Plot> mesh_plots(const Run_record& run);

/// Numbers of neighbours, least angles and energy of a 2D triangulation over the iterations. Empty unless they were
/// measured after two steps or more.
[[nodiscard]] std::vector<Plot> regularity_plots(const Run_record& run);

/// Cumulative seconds of every strategy (figure 7 of the paper), linear and logarithmic.
[[nodiscard]] std::vector<Plot> comparison_plots(const Comparison_record& comparison);

}  // namespace annulus::inline v1
