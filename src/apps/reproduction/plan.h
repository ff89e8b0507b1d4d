// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/benchmark.h>
#include <apps/reproduction/size.h>

#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The names of parts that can be selected: fig5 .. fig12, slivers, locked, movers.
[[nodiscard]] const std::vector<std::string>& reproduction_topics();

/// The motion that a benchmark follows, in the terms of the scenes' factory: densities of Lloyd as the tool names them,
/// files by their names.
struct Motion_plan {
    int dimension = 2;
    std::uint64_t vertices = 0;
    std::string density{};  ///< in 2D
    std::string surface{};  ///< in 3D: a file's name; empty: the unit sphere
    bool crossing = false;  ///< whether the surface crosses itself
    bool graded = false;
    double lock_degrees = 0;  ///< 0: none
    double movers = 0;        ///< uniform random points of which this share moves; 0: another motion
    double pace = 0;          ///< of these, in spacings
    std::uint64_t draw = 0;   ///< added to the seed, for another motion of the same kind
};

struct Part_plan {
    Motion_plan motion;
    Benchmark_plan benchmark;
};

/// The benchmarks of a reproduction, in the order in which they are run.
[[nodiscard]] std::vector<Part_plan> reproduction_parts(const Reproduction_size& size);

}  // namespace annulus::inline v1
