// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One motion under one strategy for many steps, through the public class at its real bounds.

#include <support/motions.h>

#include <annulus/engine/options.h>

#include <cstdint>
#include <string>
#include <vector>

namespace annulus::soak {

/// A way to keep the triangulation right, and its name.
struct Setting {
    std::string_view name;
    Strategy strategy;
};
inline constexpr std::array<Setting, 9> all_settings{{
    {"tolerances", Strategy::tolerances},
    {"tolerances-each", Strategy::tolerances_each},
    {"auto", Strategy::automatic},
    {"paper", Strategy::paper},
    {"paper-hybrid", Strategy::paper_hybrid},
    {"rebuild", Strategy::rebuild},
    {"relocate", Strategy::relocate},
    {"relocate-flips", Strategy::relocate_flips},
    {"in-place", Strategy::in_place},
}};

/// What to run. All that happens is a function of it, but for `audits`, which only looks.
struct Case {
    testing::Motion_kind motion{};
    Setting setting{};
    int dimension = 2;
    std::uint64_t seed = 1;
    std::uint64_t steps = 0;
    std::size_t points = 0;
    bool calls =
        false;  ///< insertions, removals, single moves and recompute_tolerances() in between, and refused calls
    std::uint64_t audits = 0;  ///< how often it is looked at in all

    [[nodiscard]] std::string name() const;
};

struct Outcome {
    std::uint64_t steps = 0;
    std::uint64_t audits = 0;
    std::uint64_t refused = 0;  ///< duplicate points that the motion brought about, rightly refused
    std::uint64_t asked = 0;
    std::uint64_t within = 0;
    std::uint64_t flips = 0;
    std::uint64_t degenerate = 0;  ///< audits that met cospherical bi-cells
    std::string fault;             ///< empty, or the first one: what and at which step
};

/// Runs until the end or the first fault.
[[nodiscard]] Outcome run(const Case& c);

/// Points and steps where none are asked for: 50,000 steps where most vertices stay within their tolerance, elsewhere
/// what takes a second or two. Functions of the case and its seed alone: no clock decides what a run does.
void choose_size(Case& c);

}  // namespace annulus::soak
