// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes -> points in 2D or 3D, random, of a lattice, rational, cospherical, collinear or coplanar, a mesh of them, and
// changes of it: insertions, removals, moves, flips that are repaired, rebuilds by several threads (common/mesh_case.h)
// -> its cells after each are those of CGAL's triangulation.
#include "common/mesh_case.h"

#include <cstdlib>
#include <iostream>

namespace {

template <int d>
void check(annulus::oracle::Bytes bytes) {
    annulus::oracle::Mesh_case<d> c(bytes);
    const std::string fault = c.fault();
    if (fault.empty()) return;
    std::cerr << "// " << fault << "\n" << c.points();
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
