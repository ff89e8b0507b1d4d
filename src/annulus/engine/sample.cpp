// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/sample.h>

#include <annulus/certificate/ladder.h>
#include <annulus/mesh/certificates.h>

namespace annulus {

namespace {

template <int d>
void add(Sample& sample, std::span<const Coordinates<d>> x, const Cell_points<d>& v, const Cell_points<d>& beyond) {
    ++sample.cells;
    Verdict verdict;
    if (!orientation_filter(tuple<d, d + 1>(v, x), false, verdict)) {
        ++sample.unclear;
        return;
    }
    if (verdict.sign <= 0) {
        ++sample.inverted;
        return;
    }
    for (std::size_t i = 0; i < v.size(); ++i) {
        if (beyond[i] == infinite) continue;
        ++sample.facets;
        const Facet_points<d> points = bicell_points(v, i, beyond[i]);
        if (!empty_sphere_filter(tuple<d, d + 2>(points, x), false, verdict)) ++sample.unclear;
        else if (verdict.sign < 0) ++sample.violated;
    }
}

}  // namespace

void add_cell(Sample& sample, std::span<const Coordinates<2>> x, const std::array<Index, 3>& v, const std::array<Index, 3>& beyond) {
    add<2>(sample, x, v, beyond);
}
void add_cell(Sample& sample, std::span<const Coordinates<3>> x, const std::array<Index, 4>& v, const std::array<Index, 4>& beyond) {
    add<3>(sample, x, v, beyond);
}

}  // namespace annulus
