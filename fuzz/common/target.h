// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The common part of moves_2.cpp and moves_3.cpp.

#include "decode.h"

#include <cstdlib>
#include <iostream>

namespace annulus::oracle {

/// Runs the program that the bytes encode. A find is shrunk and printed as code, and ends the process. At exit
/// libFuzzer's statistics are followed by the coverage of the programs.
template <int d>
void run_bytes(std::span<const std::uint8_t> bytes) {
    static Coverage& coverage = []() -> Coverage& {
        static Coverage all;
        std::atexit([] { std::cerr << all.words("stat::"); });
        return all;
    }();
    const std::string fault = run_and_shrink(Decoder(bytes).program<d>(), d == 2 ? 64 : 2, &coverage);
    if (fault.empty()) return;
    std::cerr << "// " << fault;
    std::abort();
}

}  // namespace annulus::oracle
