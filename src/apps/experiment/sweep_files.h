// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/experiment/journal.h>
#include <apps/experiment/spec.h>
#include <apps/experiment/sums.h>
#include <apps/experiment/sweep_names.h>
#include <apps/formats/output_directory.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// Writes the results of a sweep: results.jsonl, sums.json, hard.jsonl, sweep.html, which depend on the specification
/// alone; spec.toml, its `text`; and costs.jsonl, the time and memory of each trial. `entry` has the journal entry of
/// each trial.
void write_sweep(const Spec& spec, std::string_view text, const Journal& journal,
                 const std::vector<std::optional<std::size_t>>& entry, const Hard_inputs& hard, Output_directory& out);

/// The page.
[[nodiscard]] std::string sweep_html(const Spec& spec, const std::vector<Grid_point>& points);

}  // namespace annulus::inline v1
