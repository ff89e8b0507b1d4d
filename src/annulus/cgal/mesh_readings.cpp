// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh_embedding: what is read off it.
#include <annulus/cgal/mesh_embedding.h>

#include <annulus/mesh/table_readings.h>

#include <limits>

namespace annulus {

template <int d>
void Mesh_embedding<d>::list_cells(std::vector<Index>& vertices) const {
    if (dimension_ != d) {
        vertices.insert(vertices.end(), flat_cells_.begin(), flat_cells_.end());
        return;
    }
    for (const Cell_index c : table_.finite_cells()) {
        const auto v = cell_points(table_, c);
        vertices.insert(vertices.end(), v.begin(), v.end());
    }
}

template <int d>
void Mesh_embedding<d>::list_all_cells(std::vector<Index>& vertices) const {
    if (dimension_ != d) return list_cells(vertices);
    for (const Cell_index c : table_.cells()) {
        const auto v = cell_points(table_, c);
        vertices.insert(vertices.end(), v.begin(), v.end());
    }
}

template <int d>
Mesh_cells<d> Mesh_embedding<d>::cells(std::size_t bound) const {
    return dimension_ == d ? mesh_cells(table_) : mesh_cells<d>(flat_cells_, bound);
}

template <int d>
Sample Mesh_embedding<d>::sample(std::span<const Coordinates<d>> x, std::size_t count) const {
    Sample sample;
    if (dimension_ != d) return sample;
    const std::size_t stride = 1 + present_.size() / (count + 1);
    for (std::size_t v = 0; v < present_.size(); v += stride) {
        if (present_[v] == 0) continue;
        const Cell_index c = table_.cell_of(table_.corner_of(static_cast<Index>(v)));
        if (table_.is_infinite(c)) continue;
        Cell_points<d> beyond{};
        for (int i = 0; i <= d; ++i) beyond[static_cast<std::size_t>(i)] = table_.vertex(table_.twin(table_.corner(c, i)));
        add_cell(sample, x, cell_points(table_, c), beyond);
    }
    return sample;
}

template <int d>
double Mesh_embedding<d>::star_tolerance(std::span<const Coordinates<d>> home, Index v) const {
    return annulus::star_tolerance<d>(table_, home, v);
}

template <int d>
double Mesh_embedding<d>::theta(std::span<const Coordinates<d>> home, Index v) const {
    return dimension_ == d ? star_theta<d>(table_, home, v) : 1.5707963267948966;
}

template <int d>
Measures Mesh_embedding<d>::measure(std::span<const Coordinates<d>> home) const {
    if (dimension_ == d) return annulus::measure<d>(table_, home);
    Measures m;
    m.tolerance.assign(present_.size(), std::numeric_limits<double>::infinity());
    return m;
}

#define ANNULUS_READINGS(d)                                                                        \
    template void Mesh_embedding<d>::list_cells(std::vector<Index>&) const;                        \
    template void Mesh_embedding<d>::list_all_cells(std::vector<Index>&) const;                    \
    template Mesh_cells<d> Mesh_embedding<d>::cells(std::size_t) const;                            \
    template Sample Mesh_embedding<d>::sample(std::span<const Coordinates<d>>, std::size_t) const; \
    template double Mesh_embedding<d>::star_tolerance(std::span<const Coordinates<d>>, Index) const; \
    template double Mesh_embedding<d>::theta(std::span<const Coordinates<d>>, Index) const;        \
    template Measures Mesh_embedding<d>::measure(std::span<const Coordinates<d>>) const;
ANNULUS_READINGS(2)
ANNULUS_READINGS(3)
#undef ANNULUS_READINGS

}  // namespace annulus
