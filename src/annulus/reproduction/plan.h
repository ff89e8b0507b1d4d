// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/reproduction/benchmark.h>
#include <annulus/reproduction/size.h>

#include <string>
#include <vector>

namespace annulus {

/// What may be asked for by name: fig5 .. fig12, slivers, locked, movers.
[[nodiscard]] const std::vector<std::string>& reproduction_topics();

/// Which motion a race follows, in the words of the scenes' factory: densities of Lloyd as the tool names
/// them, files by their names.
struct Motion_plan {
    int dimension = 2;
    std::uint64_t vertices = 0;
    std::string density{};  ///< plane
    std::string surface{};  ///< space: a file's name; empty: the unit sphere
    bool crossing = false;  ///< the surface crosses itself
    bool graded = false;
    double lock_degrees = 0;  ///< 0: none
    double movers = 0;        ///< uniform random points of which this share moves; 0: none of the above is so
    double pace = 0;          ///< of these, by so many spacings
    std::uint64_t draw = 0;   ///< another one of the same kind: is added to the seed
};

struct Part_plan {
    Motion_plan motion;
    Benchmark_plan benchmark;
};

/// The races of a reproduction, in the order in which they are run.
[[nodiscard]] std::vector<Part_plan> reproduction_parts(const Reproduction_size& size);

}  // namespace annulus
