// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes -> a point set and a program of moves, insertions and removals in space -> the library and a model beside
// it (common/program.h). A find is printed as code for tests/relocation/finds.cpp.
#include "common/decode.h"

#include <cstdlib>
#include <iostream>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    annulus::oracle::Decoder decoder(std::span(data, size));
    const annulus::oracle::Program_3 program = decoder.program<3>();
    const std::string fault = annulus::oracle::run(program, 2);
    if (fault.empty()) return 0;
    std::cerr << "// " << fault << "\n" << annulus::oracle::as_code(program);
    std::abort();
}
