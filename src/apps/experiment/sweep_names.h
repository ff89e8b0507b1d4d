// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <string_view>

namespace annulus::inline v1 {

/// The journal of an unfinished sweep, in its output directory.
inline constexpr const char* journal_name = ".sweep-journal";
/// The files that a sweep writes.
inline constexpr std::array<std::string_view, 6> sweep_results{"results.jsonl", "sums.json", "hard.jsonl",
                                                               "sweep.html",    "spec.toml", "costs.jsonl"};
/// Whether it is one of these, or the journal.
[[nodiscard]] inline bool is_sweep_file(std::string_view name) {
    return name == journal_name || std::find(sweep_results.begin(), sweep_results.end(), name) != sweep_results.end();
}

}  // namespace annulus::inline v1
