// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// One motion under one strategy, or in a periodic box, for many steps, through the public class at its real bounds.

#include <support/motions.h>

#include <annulus/options.h>

#include <cstdint>
#include <string>
#include <vector>

namespace annulus::soak {

/// An update strategy with its settings, and its name; or that of a periodic box.
struct Setting {
    std::string_view name;
    Strategy strategy;
    bool periodic = false;
    Periodic_strategy in_box = Periodic_strategy::automatic;
};
inline constexpr std::array<Setting, 11> all_settings{{
    {"tolerances", Strategy::tolerances},
    {"tolerances-each", Strategy::tolerances_each},
    {"auto", Strategy::automatic},
    {"paper", Strategy::paper},
    {"paper-hybrid", Strategy::paper_hybrid},
    {"rebuild", Strategy::rebuild},
    {"relocate", Strategy::relocate},
    {"relocate-flips", Strategy::relocate_flips},
    {"in-place", Strategy::in_place},
    {"periodic", Strategy::automatic, true},
    {"periodic-tolerances", Strategy::automatic, true, Periodic_strategy::tolerances},
}};

/// A case to run. The whole run is a function of it, except of `audits`, which changes nothing.
struct Case {
    testing::Motion_kind motion{};
    Setting setting{};
    int dimension = 2;
    std::uint64_t seed = 1;
    std::uint64_t steps = 0;
    std::size_t points = 0;
    /// Insertions, removals and refused calls in between, single moves and recompute_tolerances(); in a periodic box
    /// meshes that are made of saved ones.
    bool calls = false;
    std::uint64_t audits = 0;  ///< total number of audits

    [[nodiscard]] std::string name() const;
};

struct Outcome {
    std::uint64_t steps = 0;
    std::uint64_t audits = 0;
    std::uint64_t refused = 0;  ///< duplicate points of the motion, correctly refused
    std::uint64_t asked = 0;
    std::uint64_t within = 0;
    std::uint64_t flips = 0;
    std::uint64_t degenerate = 0;  ///< audits that met cospherical bi-cells
    std::string fault;             ///< empty, or the first fault and its step
};

/// Runs until the end or the first fault.
[[nodiscard]] Outcome run(const Case& c);
[[nodiscard]] Outcome run_periodic(const Case& c);

/// The default numbers of points and steps: 50,000 steps where most vertices stay within their tolerance, elsewhere as
/// many as take a second or two. Functions of the case and its seed alone: no clock influences a run.
void choose_size(Case& c);

}  // namespace annulus::soak
