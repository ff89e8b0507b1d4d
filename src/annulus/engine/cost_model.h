// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/exact_sign.h>

namespace annulus::inline v1 {

/// What work costs, in cells that are tested with all others (Sign_evaluator::test_all_cells, four at a time): 10 ns
/// each in 3D and 6 ns in 2D on one machine. The ratios were measured there (bench/README.md). Correctness does not
/// depend on them, and the same input gives the same run whatever they are.
template <int d>
struct Cost_model;

template <>
struct Cost_model<2> {
    // Per vertex, of a time step:
    static constexpr double insertion = 68.0;  // all points one by one, in the reference library of bench/
    static constexpr double rebuild = 24.0;
    static constexpr double cells = 2.0;  // the signs of everything: cells per vertex
    static constexpr double signs = 2.3;  // plus what is written for each vertex
    static constexpr double recomputation = 44.0;
    // Per cell or facet, found by a sample:
    static constexpr double violated = 31.0;
    static constexpr double inverted = 246.0;
    static constexpr double unclear = 8.0;
    // Per event:
    static constexpr double alone = 3.8;     // a cell tested by itself, not with all others
    static constexpr double flip = 30.0;     // besides the cells that are tested
    static constexpr double point = 600.0;   // of a cavity that is rebuilt
    static constexpr double filter = 1.9;    // a sign by itself
    static constexpr double integers = 6.0;  // of fixed width
    static constexpr double interval = 13.0;
    static constexpr double exact = 95.0;          // by integers of any size
    static constexpr double reinsertion = 1900.0;  // of a vertex, besides what is evaluated
    static constexpr double border = 0.8;          // a facet of the border, when it is walked
    // Per event, with tolerances:
    static constexpr double failure = 12.0;
    static constexpr double evaluation = 17.5;
    static constexpr double star = 26.0;         // for comparison: the signs around a vertex that moves alone
    static constexpr double certificates = 5.0;  // per vertex
    static constexpr double expected = 13.5;     // per certificate that the estimate lets expire
};

template <>
struct Cost_model<3> {
    static constexpr double insertion = 264.0;
    static constexpr double rebuild = 75.0;
    static constexpr double cells = 6.7;
    static constexpr double signs = 7.4;
    static constexpr double recomputation = 201.0;
    static constexpr double violated = 13.0;
    static constexpr double inverted = 277.0;
    static constexpr double unclear = 73.0;
    static constexpr double alone = 3.0;
    static constexpr double flip = 35.0;
    static constexpr double point = 380.0;
    static constexpr double filter = 1.9;
    static constexpr double integers = 8.0;
    static constexpr double interval = 17.0;
    static constexpr double exact = 190.0;
    static constexpr double reinsertion = 3000.0;
    static constexpr double border = 7.0;
    static constexpr double failure = 36.0;
    static constexpr double evaluation = 8.7;
    static constexpr double star = 145.0;
    static constexpr double certificates = 20.0;
    static constexpr double expected = 11.4;
};

/// How many times as much failures and evaluations cost in a periodic box, by bench/motions/torus.cpp: certificates are
/// evaluated at places that are computed, and found without the order that cells of an open mesh have in memory.
inline constexpr double in_periodic_box = 3.0;

/// What moves in a periodic box cost, in the same unit, by what was measured of 10,000 points.
template <int d>
struct Periodic_costs;

template <>
struct Periodic_costs<2> {
    static constexpr double reinsertion = 2700.0;  // of a vertex
    static constexpr double signs = 4.4;           // of all, per vertex
    static constexpr double tolerances = 1.7;      // the same, where they are kept
    static constexpr double flips = 300.0;         // for a vertex that goes less than a spacing
    static constexpr double build = 80.0;          // per vertex
    // Of a build, per copy of a point, as long as flips may go on: flips of cells with offsets take two to four times
    // what Cost_model says, so it is less than for builds without.
    static constexpr double copy = 36.0;
};

template <>
struct Periodic_costs<3> {
    static constexpr double reinsertion = 9000.0;
    static constexpr double signs = 14.0;
    static constexpr double tolerances = 2.3;
    static constexpr double flips = 2000.0;
    static constexpr double build = 500.0;
    static constexpr double copy = 80.0;
};
inline constexpr double small_build_in_box = 8000.0;  // and a little, for few points

/// The cost of a sign that the filter stage left open, by the stage that decided it.
template <int d>
[[nodiscard]] constexpr double cost_of(const Staged_sign& s) {
    if (s.stage == Stage::interval) return Cost_model<d>::interval;
    return s.of_any_size ? Cost_model<d>::exact : Cost_model<d>::integers;
}
/// How much such a sign counts as a hint that repair is going to cost more than expected (Rebuild_policy::expected,
/// which was fitted when intervals and integers of any size decided all of them).
template <int d>
[[nodiscard]] constexpr double doubt_of(const Staged_sign& s) {
    if (s.stage == Stage::interval) return Cost_model<d>::interval;
    return s.of_any_size || s.sign == 0 ? Cost_model<d>::exact : Cost_model<d>::exact / 3.0;
}

/// Extra cost of the tolerance of a certificate, when a later stage computes it.
inline constexpr double interval_evaluation_cost = 35.0;
inline constexpr double exact_evaluation_cost = 470.0;

}  // namespace annulus::inline v1
