// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/experiment/journal.h>
#include <annulus/experiment/spec.h>
#include <annulus/experiment/sums.h>
#include <annulus/formats/output_directory.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace annulus {

/// The journal of a sweep that is not done, in its output directory.
inline constexpr const char* journal_name = ".sweep-journal";
/// Those that a sweep writes.
inline constexpr std::array<std::string_view, 6> sweep_results{"results.jsonl", "sums.json", "hard.jsonl", "sweep.html", "spec.toml", "costs.jsonl"};
/// One of these, or the journal.
[[nodiscard]] bool is_sweep_file(std::string_view name);

/// Writes what a sweep has found: results.jsonl, sums.json, hard.jsonl, sweep.html, which depend on the specification alone; spec.toml, its
/// `text`; and costs.jsonl, what each trial took. `entry` says where in the journal each trial is.
void write_sweep(const Spec& spec, std::string_view text, const Journal& journal, const std::vector<std::optional<std::size_t>>& entry,
                 const Hard_inputs& hard, Output_directory& out);

/// The page.
[[nodiscard]] std::string sweep_html(const Spec& spec, const std::vector<Grid_point>& points);

}  // namespace annulus
