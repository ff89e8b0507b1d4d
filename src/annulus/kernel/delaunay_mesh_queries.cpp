// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay_mesh: its queries.
#include <annulus/kernel/delaunay_mesh.h>

#include <annulus/mesh/list_cells.h>
#include <annulus/mesh/table_measures.h>

#include <algorithm>
#include <limits>

namespace annulus::inline v1 {

template <int d>
void Delaunay_mesh<d>::list_cells(std::span<const Coordinates<d>> positions, std::vector<Index>& vertices) const {
    if (dimension_ == d) {
        for (const Cell_index c : table_.finite_cells()) {
            const auto v = cell_vertices(table_, c);
            vertices.insert(vertices.end(), v.begin(), v.end());
        }
        return;
    }
    for (const auto& v : flat_cells(positions).vertices) {
        if (std::find(v.begin(), v.end(), infinite) != v.end()) continue;
        vertices.insert(vertices.end(), v.begin(), v.end());
        if constexpr (d == 3) vertices.push_back(none);
    }
}

template <int d>
void Delaunay_mesh<d>::list_all_cells(std::span<const Coordinates<d>> positions, std::vector<Index>& vertices) const {
    if (dimension_ != d) return list_cells(positions, vertices);
    for (const Cell_index c : table_.cells()) {
        const auto v = cell_vertices(table_, c);
        vertices.insert(vertices.end(), v.begin(), v.end());
    }
}

template <int d>
Mesh_cells<d> Delaunay_mesh<d>::cells(std::span<const Coordinates<d>> positions) const {
    if (dimension_ == d) return mesh_cells(table_);
    std::vector<Index> corners;
    list_cells(positions, corners);
    return without_neighbours<d>(corners);
}

template <int d>
double Delaunay_mesh<d>::star_tolerance(std::span<const Coordinates<d>> positions, Index v) const {
    return annulus::star_tolerance<d>(table_, positions, v);
}

template <int d>
double Delaunay_mesh<d>::theta(std::span<const Coordinates<d>> positions, Index v) const {
    return dimension_ == d ? star_theta<d>(table_, positions, v) : 1.5707963267948966;
}

template <int d>
Measures Delaunay_mesh<d>::measure(std::span<const Coordinates<d>> positions) const {
    Measures m;
    if (dimension_ == d) m = annulus::measure<d>(table_, positions);
    else m.tolerance.assign(positions.size(), std::numeric_limits<double>::infinity());
    for (std::size_t v = 0; v < m.tolerance.size(); ++v)
        if (v >= vertices_.bound() || !has(static_cast<Index>(v)))
            m.tolerance[v] = std::numeric_limits<double>::quiet_NaN();
    return m;
}

#define ANNULUS_INSTANTIATE(d)                                                                                  \
    template void Delaunay_mesh<d>::list_cells(std::span<const Coordinates<d>>, std::vector<Index>&) const;     \
    template void Delaunay_mesh<d>::list_all_cells(std::span<const Coordinates<d>>, std::vector<Index>&) const; \
    template Mesh_cells<d> Delaunay_mesh<d>::cells(std::span<const Coordinates<d>>) const;                      \
    template double Delaunay_mesh<d>::star_tolerance(std::span<const Coordinates<d>>, Index) const;             \
    template double Delaunay_mesh<d>::theta(std::span<const Coordinates<d>>, Index) const;                      \
    template Measures Delaunay_mesh<d>::measure(std::span<const Coordinates<d>>) const;
ANNULUS_INSTANTIATE(2)
ANNULUS_INSTANTIATE(3)
#undef ANNULUS_INSTANTIATE

}  // namespace annulus::inline v1
