// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes -> a periodic box in 2D or 3D, thin, skewed, tiny, points in it, and changes: moves, other boxes, insertions,
// removals, refused calls (common/periodic_case.h) -> the audit of every Periodic_mesh, in integers, and what agrees
// with its cells. A find is printed with the mesh before it, as it is saved.
#include "common/periodic_case.h"

#include <cstdlib>
#include <iostream>

namespace {

template <int d>
void check(annulus::oracle::Bytes bytes) {
    annulus::oracle::Periodic_case<d> c(bytes);
    const std::string fault = c.fault();
    if (fault.empty()) return;
    std::cerr << "// " << fault << "\n" << c.words();
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const annulus::oracle::Bytes bytes(std::span(data, size));
    if (data[0] % 2 == 0) check<2>(bytes);
    else check<3>(bytes);
    return 0;
}
