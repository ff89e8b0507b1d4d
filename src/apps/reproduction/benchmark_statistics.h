// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/records.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

// Statistics of records: nothing is measured here.
namespace annulus::inline v1 {

/// Null if there is none with that name.
[[nodiscard]] const Contender_record* contender_of(const Benchmark_record& benchmark, const std::string& name);

/// Seconds up to the end of each step that was followed. A step that was not followed counts as the next one that
/// was. Tolerances of the beginning come first.
[[nodiscard]] std::vector<std::pair<std::uint64_t, double>> cumulated(const Contender_record& contender);
/// Sum over all steps.
[[nodiscard]] double total_seconds(const Benchmark_record& benchmark, const std::string& contender);
/// The factor by which `quick` is faster than `slow` over the whole benchmark; 0 if one is missing.
[[nodiscard]] double speed_up(const Benchmark_record& benchmark, const std::string& slow, const std::string& quick);
/// The same for some steps in the middle of about each decade: mean seconds per step of `slow` over those of `quick` in
/// (from, to].
[[nodiscard]] double speed_up_between(const Benchmark_record& benchmark, const std::string& slow,
                                      const std::string& quick, std::uint64_t from, std::uint64_t to);

/// Mean seconds per step of the first tenth over that of the last.
[[nodiscard]] double acceleration(const Benchmark_record& benchmark, const std::string& contender);
/// Seconds of a step over those of a mean rebuild: the largest ratio, or the one that a hundredth of the steps exceeds.
[[nodiscard]] double longest_step(const Benchmark_record& benchmark, const std::string& contender,
                                  double exceeding = 0);
/// Share of the steps that took longer than a mean rebuild.
[[nodiscard]] double slower_steps(const Benchmark_record& benchmark, const std::string& contender);

/// Share of all moves that failed.
[[nodiscard]] double failed_share(const Benchmark_record& benchmark, const std::string& contender);
/// Share of moves that failed, a mean over a tenth of the steps up to `step`.
[[nodiscard]] double failures_at(const Benchmark_record& benchmark, const std::string& contender, std::uint64_t step);
/// The first step from which on the mean share of failures over a tenth more steps is this small.
[[nodiscard]] std::optional<std::uint64_t> first_step_below(const Benchmark_record& benchmark,
                                                            const std::string& contender, double share);
/// Certificates evaluated per failure.
[[nodiscard]] double updates_at(const Benchmark_record& benchmark, const std::string& contender, std::uint64_t step);
/// The most vertices that were anchored in one time step, as a share of all vertices.
[[nodiscard]] double most_renewals(const Benchmark_record& benchmark, const std::string& contender);

/// The share of moves within tolerance from which on a strategy takes no longer than rebuilding; absent if this is
/// never so, or always.
[[nodiscard]] std::optional<double> switch_point(const Benchmark_record& benchmark, const std::string& contender);

/// The angle in degrees below which a hundredth of the dihedral angles are: linear in its bin.
[[nodiscard]] double small_angle(const Quality_record& quality);

/// Null if nothing was measured before that step.
[[nodiscard]] const Certificate_survey_record* survey_at(const Benchmark_record& benchmark, std::uint64_t step);
[[nodiscard]] const Quality_record* quality_at(const Benchmark_record& benchmark, std::uint64_t step);

}  // namespace annulus::inline v1
