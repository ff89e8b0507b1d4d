// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace annulus {

/// What things cost, in cells looked at (Signs::look_at): some 60 ns in space and 30 in the plane on one machine. Ratios measured there
/// (bench/README.md); nothing here has a say in what is right, and the same input gives the same run whatever they are.
template <int d>
struct Prices;

template <>
struct Prices<2> {
    // A vertex, of a timestamp:
    static constexpr double rebuild = 16.0;  // by CGAL
    static constexpr double again = 11.7;    // by a rebuild of ours, in the order of the last one
    static constexpr double cells = 2.0;     // the signs of everything: cells a vertex
    static constexpr double signs = 2.5;     // with what is written for each vertex
    static constexpr double mirror = 4.0;
    static constexpr double settling = 9.0;
    // Each, of cells that a sample shows:
    static constexpr double violated = 12.0;
    static constexpr double inverted = 95.0;
    static constexpr double unclear = 20.0;
    // Each, with tolerances:
    static constexpr double failure = 5.2;
    static constexpr double evaluation = 8.0;
    static constexpr double star = 6.6;      // for comparison: the signs around a vertex that moves alone
    static constexpr double certificates = 5.0;  // a vertex
    static constexpr double expected = 5.3;  // of a certificate that the outlook lets expire
};

template <>
struct Prices<3> {
    static constexpr double rebuild = 55.0;
    static constexpr double again = 57.0;
    static constexpr double cells = 6.75;
    static constexpr double signs = 9.3;
    static constexpr double mirror = 13.0;
    static constexpr double settling = 50.0;
    static constexpr double violated = 10.5;
    static constexpr double inverted = 230.0;
    static constexpr double unclear = 20.0;
    static constexpr double failure = 28.0;
    static constexpr double evaluation = 7.0;
    static constexpr double star = 38.0;
    static constexpr double certificates = 20.0;
    static constexpr double expected = 8.6;
};

/// A certificate's tolerance by the later stages, besides.
inline constexpr double interval_evaluation_price = 20.0;
inline constexpr double exact_evaluation_price = 100.0;

}  // namespace annulus
