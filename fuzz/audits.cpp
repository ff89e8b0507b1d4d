// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes -> up to eight points in 2D or 3D and a Delaunay triangulation of them, damaged by dropping, doubling,
// reversing, flipping and renumbering -> the audit and brute force (common/brute_force.h), which must agree. A find is
// printed as code for tests/mesh/brute_force_test.cpp.
#include "common/audit_case.h"

#include <cstdlib>
#include <iostream>

namespace {

template <int d>
void check(annulus::oracle::Bytes bytes) {
    const auto c = annulus::oracle::decode_audit_case<d>(bytes);
    const std::string fault = annulus::oracle::audit_fault(c);
    if (fault.empty()) return;
    std::cerr << "// " << fault << "\n" << as_code(c) << "\n";
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    annulus::oracle::Bytes bytes(std::span(data, size));
    if (bytes.next() % 2 == 0) check<2>(bytes);
    else check<3>(bytes);
    return 0;
}
