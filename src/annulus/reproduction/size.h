// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
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

}  // namespace annulus
