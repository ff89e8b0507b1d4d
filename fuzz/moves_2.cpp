// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes -> a point set and a program of moves, motions, insertions and removals in 2D -> the library and a model
// (common/program.h). A find is shrunk and printed as code for tests/engine/finds.cpp.
#include "common/target.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    annulus::oracle::run_bytes<2>(std::span(data, size));
    return 0;
}
