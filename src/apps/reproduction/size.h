// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The extent of a reproduction.
struct Reproduction_size {
    bool quick = false;
    std::uint64_t iterations = 0;  ///< of every motion; 0: as many as in the paper, or 100 and 60 in a quick one
    std::uint64_t seed = 1;
    std::vector<std::string> only{};  ///< of `reproduction_topics`; empty: all
    bool surfaces = false;            ///< whether the paper's surfaces, or substitutes, are available
};

}  // namespace annulus::inline v1
