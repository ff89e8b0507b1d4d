// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/write_csv.h>
#include <apps/report/run_record.h>

#include <nlohmann/json.hpp>

#include <string>

namespace annulus::inline v1 {

/// The content of summary.json: the keys of every run in a fixed order, then memory and the unit of length. Only an
/// interrupted run has `interrupted`.
[[nodiscard]] nlohmann::ordered_json summary_json(const Run_record& run);

/// Adds the keys `columns`, `box` and `ignored`, unless they are empty.
void append_input(nlohmann::ordered_json& json, const Input_record& input);

/// "a box", "a polygon with 5 corners", "7 half-spaces".
[[nodiscard]] std::string in_words(const Clip_record& clip);

/// The content of compare.json: `command`, `version`, `agree`, `strategies` by name, and `ratios` "a/b", the
/// triangulation seconds of a over those of b, for every ordered pair (null when b took no time), `ratios_of_medians`,
/// the same of the median step (finding.h), then any `disagreements`. An interrupted comparison has `interrupted` in
/// place of `agree` and ratios. Throws Error(usage) when two runs have the same strategy.
[[nodiscard]] nlohmann::ordered_json compare_json(const Comparison_record& comparison);

/// The content of iterations.csv: one row per step. Where meshes were measured, further columns are failures (moves
/// beyond tolerance), updates per failure (certificates evaluated) and the members of Mesh_step.
[[nodiscard]] Csv_table iterations_table(const Run_record& run);

/// The content of dihedral.csv: counts of dihedral angles, 5 degrees per column, before the first step (iteration 0)
/// and after each measured step.
[[nodiscard]] Csv_table dihedral_table(const Run_record& run);

}  // namespace annulus::inline v1
