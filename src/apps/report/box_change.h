// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/run_record.h>

#include <string>

namespace annulus::inline v1 {

/// Whether the periodic box of a run was not the same in all frames. Then displacements are relative to the box.
[[nodiscard]] inline bool box_changes(const Run_record& run) { return !run.input.box_before.empty(); }

/// Whether the box changes and no point moves relative to it by more than rounding, 1e-12 mean spacings. Linear.
[[nodiscard]] bool only_box_moves(const Run_record& run);

/// A sentence on the box at the end and at the start: its volume (in 2D area), and the lengths and angles of its
/// vectors where they are others. Empty unless the box changes.
[[nodiscard]] std::string on_box(const Run_record& run);

}  // namespace annulus::inline v1
