// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

namespace annulus {

/// What work costs, in cells tested (Sign_evaluator::test_cell): about 24 ns each in 3D and 21 ns in 2D on one
/// machine. The ratios were measured there (bench/README.md). Correctness does not depend on them, and the same input
/// gives the same run whatever they are.
template <int d>
struct Cost_model;

template <>
struct Cost_model<2> {
    // Per vertex, of a time step:
    static constexpr double insertion = 22.5;  // all points one by one (CGAL): the reference for the cost of a step
    static constexpr double rebuild = 12.4;
    static constexpr double cells = 2.0;   // the signs of everything: cells per vertex
    static constexpr double signs = 2.45;  // plus what is written for each vertex
    static constexpr double recomputation = 13.7;
    // Per cell or facet, found by a sample:
    static constexpr double violated = 14.0;
    static constexpr double inverted = 112.0;
    static constexpr double unclear = 10.0;
    // Per event:
    static constexpr double alone = 1.4;    // a cell tested by itself, not with all others
    static constexpr double flip = 12.0;    // besides the cells that are tested
    static constexpr double point = 230.0;  // of a cavity that is rebuilt
    static constexpr double filter = 0.7;   // a sign by itself
    static constexpr double interval = 10.0;
    static constexpr double exact = 70.0;
    static constexpr double reinsertion = 700.0;  // of a vertex, besides what is evaluated
    static constexpr double border = 0.3;         // a facet of the border, when it is walked
    // Per event, with tolerances:
    static constexpr double failure = 4.5;
    static constexpr double evaluation = 6.5;
    static constexpr double star = 9.5;          // for comparison: the signs around a vertex that moves alone
    static constexpr double certificates = 5.0;  // per vertex
    static constexpr double expected = 4.8;      // per certificate that the estimate lets expire
};

template <>
struct Cost_model<3> {
    static constexpr double insertion = 125.0;
    static constexpr double rebuild = 48.0;
    static constexpr double cells = 6.7;
    static constexpr double signs = 8.0;
    static constexpr double recomputation = 94.0;
    static constexpr double violated = 10.0;
    static constexpr double inverted = 210.0;
    static constexpr double unclear = 37.0;
    static constexpr double alone = 1.8;
    static constexpr double flip = 26.0;
    static constexpr double point = 400.0;
    static constexpr double filter = 1.2;
    static constexpr double interval = 26.0;
    static constexpr double exact = 170.0;
    static constexpr double reinsertion = 2800.0;
    static constexpr double border = 4.0;
    static constexpr double failure = 25.0;
    static constexpr double evaluation = 6.0;
    static constexpr double star = 60.0;
    static constexpr double certificates = 20.0;
    static constexpr double expected = 6.5;
};

/// Extra cost of the tolerance of a certificate, when a later stage computes it.
inline constexpr double interval_evaluation_cost = 14.0;
inline constexpr double exact_evaluation_cost = 167.0;

}  // namespace annulus
