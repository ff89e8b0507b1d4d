// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstdint>
#include <optional>
#include <string_view>

namespace annulus::inline v1 {

/// How the triangulation is kept right.
enum class Strategy : std::uint8_t {
    rebuild,         ///< from scratch at every call (Builder)
    relocate,        ///< one vertex at a time: remove, locate, insert (the paper's baseline)
    relocate_flips,  ///< one vertex at a time: its position is written if no flip is needed, else relocate (paper 3.1)
    /// One vertex at a time: its certificates are evaluated, and flips repair what is violated; no tolerances.
    in_place,
    tolerances,       ///< whole time steps: only certificates whose tolerance expired are evaluated
    tolerances_each,  ///< one vertex at a time, Delaunay after each
    /// Whole time steps, `auto`: the cheapest of tolerances, signs with flips, and rebuilding, judged by counts of
    /// work.
    automatic,
    paper,         ///< the paper's algorithm (3.2), one vertex at a time: Options::tolerance says by which tolerances
    paper_hybrid,  ///< rebuild until a sample stays within tolerance, then `paper` (paper 4.2)
};

[[nodiscard]] constexpr std::string_view name_of(Strategy s) {
    switch (s) {
        case Strategy::rebuild: return "rebuild";
        case Strategy::relocate: return "relocate";
        case Strategy::relocate_flips: return "relocate-flips";
        case Strategy::in_place: return "in-place";
        case Strategy::tolerances: return "tolerances";
        case Strategy::tolerances_each: return "tolerances-each";
        case Strategy::automatic: return "auto";
        case Strategy::paper: return "paper";
        case Strategy::paper_hybrid: return "paper-hybrid";
    }
    return "";
}

/// Which number is used as the tolerance of a certificate.
enum class Tolerance_kind : std::uint8_t {
    certified,  ///< a proved lower bound
    paper,      ///< the standard annulus and parallel hyperplanes in plain double, no certificates of cells
    floating,   ///< the same certificates and formulas as `certified`, in plain double without error bounds
};

[[nodiscard]] constexpr std::string_view name_of(Tolerance_kind kind) {
    return kind == Tolerance_kind::certified ? "certified" : kind == Tolerance_kind::paper ? "paper" : "floating";
}

[[nodiscard]] std::optional<Strategy> strategy_named(std::string_view name);
[[nodiscard]] std::optional<Tolerance_kind> tolerance_kind_named(std::string_view name);

/// How the triangulation is kept right in a periodic box.
enum class Periodic_strategy : std::uint8_t {
    automatic,   ///< tolerances while they pay, judged by counts of work; otherwise signs
    signs,       ///< the signs of all certificates in each step; never tolerances
    tolerances,  ///< only certificates whose tolerance expired are evaluated; always tolerances
};

[[nodiscard]] constexpr std::string_view name_of(Periodic_strategy s) {
    return s == Periodic_strategy::automatic ? "auto" : s == Periodic_strategy::signs ? "signs" : "tolerances";
}

[[nodiscard]] std::optional<Periodic_strategy> periodic_strategy_named(std::string_view name);

/// What a caller can choose, as one value.
struct Options {
    Strategy strategy = Strategy::automatic;
    /// Kinds other than this only with `paper` and `paper_hybrid`, else Error(usage).
    Tolerance_kind tolerance = Tolerance_kind::certified;
    int threads = 1;                ///< 1 or more, else Error(usage); results do not depend on it
    bool merge_duplicates = false;  ///< equal input points become one vertex instead of an error
    /// List the cells that came and went in a call: Move_result::changed, gone. The default is off in every language:
    /// a step in which no cell changes costs the same with lists, but where most change, to sort them may take longer
    /// than the step; and in C a member that is 0 has its default.
    bool report_changes = false;
    std::uint64_t seed = 0;  ///< of the sample that `paper_hybrid` draws
};

}  // namespace annulus::inline v1
