// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/reproduction/race.h>

#include <string>
#include <vector>

namespace annulus {

/// How much is run.
struct Reproduction_size {
    bool quick = false;
    std::uint64_t iterations = 0;  ///< of every motion; 0: as many as the paper's, or 100 and 60 of a quick one
    std::uint64_t seed = 1;
    std::vector<std::string> only{};  ///< of `reproduction_topics`; empty: all
    bool surfaces = false;            ///< whether the paper's bodies are at hand, or what stands for them
};

/// What may be asked for by name: fig5 .. fig12, slivers, locked.
[[nodiscard]] const std::vector<std::string>& reproduction_topics();

/// Which motion a race follows, in words that whoever makes scenes understands: densities of Lloyd as the tool names them, files by their names.
struct Motion_plan {
    int dimension = 2;
    std::uint64_t vertices = 0;
    std::string density{};  ///< plane
    std::string surface{};  ///< space: a file's name; empty: the unit sphere
    bool crossing = false;  ///< the surface crosses itself
    bool graded = false;
    double lock_degrees = 0;  ///< 0: none
};

struct Part_plan {
    Motion_plan motion;
    Race_plan race;
};

/// The races of a reproduction, in the order in which they are run.
[[nodiscard]] std::vector<Part_plan> reproduction_parts(const Reproduction_size& size);

}  // namespace annulus
