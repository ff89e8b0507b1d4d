// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/sample.h>

#include <annulus/mesh/certificates.h>
#include <annulus/predicate/filtered.h>

namespace annulus::inline v1 {

namespace {

template <int d>
void add_cell(Sample& sample, const Corner_table<d>& t, std::span<const Coordinates<d>> x, Cell_index c) {
    ++sample.cells;
    const Cell_sites<d> v = cell_sites(t, c);
    Certificate_value value;
    if (!orientation_filter(tuple<d, d + 1>(v, x), false, value)) {
        ++sample.unclear;
        return;
    }
    if (value.sign <= 0) {
        ++sample.inverted;
        return;
    }
    for (std::size_t i = 0; i < v.size(); ++i) {
        const Site<d> beyond = t.opposite(t.corner(c, static_cast<int>(i)));
        if (beyond.vertex == infinite) continue;
        ++sample.facets;
        const Facet_sites<d> points = bicell_sites(v, i, beyond);
        if (!empty_sphere_filter(tuple<d, d + 2>(points, x), false, value)) ++sample.unclear;
        else if (value.sign < 0) ++sample.violated;
    }
}

}  // namespace

template <int d>
Sample sample_cells(const Corner_table<d>& t, std::span<const Coordinates<d>> x, std::size_t count) {
    Sample sample;
    const auto bound = static_cast<std::size_t>(t.vertex_bound());
    for (std::size_t v = 0; v < bound; v += 1 + bound / (count + 1)) {
        const Corner_index h = t.corner_of(static_cast<Index>(v));
        if (h != no_corner && !t.is_infinite(t.cell_of(h))) add_cell(sample, t, x, t.cell_of(h));
    }
    return sample;
}

template Sample sample_cells<2>(const Corner_table<2>&, std::span<const Coordinates<2>>, std::size_t);
template Sample sample_cells<3>(const Corner_table<3>&, std::span<const Coordinates<3>>, std::size_t);

}  // namespace annulus::inline v1
