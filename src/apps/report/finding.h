// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/run_record.h>

#include <string>
#include <vector>

namespace annulus::inline v1 {

/// What a run found, in one or two paragraphs of text for the head of its page: how the mesh or the Voronoi cells have
/// changed, how far points moved, and what the triangulation took. Without a step, what is known of the start.
[[nodiscard]] std::vector<std::string> findings(const Run_record& run);

/// Which strategy was the fastest, and by how much. Nothing of fewer than two runs, or where no time was measured.
[[nodiscard]] std::vector<std::string> findings(const Comparison_record& comparison);

/// The median over the steps of the seconds spent on the triangulation: where these are of the wall clock, it changes
/// little as long as fewer than half of the steps have a pause of the machine. 0 without steps. Linear.
[[nodiscard]] double median_step(const Run_record& run);

}  // namespace annulus::inline v1
