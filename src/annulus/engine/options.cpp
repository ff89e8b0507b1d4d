// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/options.h>

namespace annulus::inline v1 {

std::optional<Strategy> strategy_named(std::string_view name) {
    for (const Strategy s :
         {Strategy::rebuild, Strategy::relocate, Strategy::relocate_flips, Strategy::in_place, Strategy::tolerances,
          Strategy::tolerances_each, Strategy::automatic, Strategy::paper, Strategy::paper_hybrid})
        if (name_of(s) == name) return s;
    return std::nullopt;
}

std::optional<Tolerance_kind> tolerance_kind_named(std::string_view name) {
    for (const Tolerance_kind k : {Tolerance_kind::certified, Tolerance_kind::paper, Tolerance_kind::floating})
        if (name_of(k) == name) return k;
    return std::nullopt;
}

std::optional<Periodic_strategy> periodic_strategy_named(std::string_view name) {
    for (const Periodic_strategy s :
         {Periodic_strategy::automatic, Periodic_strategy::signs, Periodic_strategy::tolerances})
        if (name_of(s) == name) return s;
    return std::nullopt;
}

}  // namespace annulus::inline v1
