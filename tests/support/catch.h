// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Catch2, version 2 or 3, under names that both have or that are defined here for both. Tests include this header and
// none of Catch2.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
#else
#include <catch2/catch.hpp>
#endif

#include <cstdint>
#include <string>

#if CATCH_VERSION_MAJOR >= 3
using Catch::Approx;
#endif

namespace annulus {

/// The seed of this run of the tests, which main prints.
inline std::uint32_t run_seed() {
#if CATCH_VERSION_MAJOR >= 3
    return Catch::getSeed();
#else
    return Catch::rngSeed();
#endif
}

/// Whether a string contains this text.
inline auto contains(const std::string& words) {
#if CATCH_VERSION_MAJOR >= 3
    return Catch::Matchers::ContainsSubstring(words);
#else
    return Catch::Contains(words);
#endif
}

}  // namespace annulus
