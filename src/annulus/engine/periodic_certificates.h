// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/certificate_expiries.h>
#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A periodic table and what it is of.
template <int d>
struct Periodic_view {
    const Periodic_table<d>& table;
    const Lattice<d>& lattice;
    std::span<const Coordinates<d>> place;  ///< by vertex
};

/// A certificate of a periodic table that has been evaluated.
template <int d>
struct Evaluated_certificate {
    Certificate_id id;
    bool holds;        ///< cospherical points by the perturbation
    bool cospherical;  ///< exactly
    double tolerance;  ///< a lower bound; 0 unless the sign is positive
    double radius;     ///< an upper bound: its points are within it of some point
    std::array<Index, static_cast<std::size_t>(d + 2)> vertex;  ///< of its points; a cell has `none` last
};

/// The id of the facet opposite to corner i of cell c: that of its half with the lesser number.
template <int d>
[[nodiscard]] Certificate_id facet_id(const Periodic_table<d>& table, std::size_t c, std::size_t i) {
    return id_of_facet(std::min(table.corner(c, i), table.twin[c][i]));
}
[[nodiscard]] inline Certificate_id periodic_cell_id(std::size_t c) {
    return id_of_cell(Cell_index(static_cast<Index>(c)));
}
/// Whether the table has this certificate: the cell, or the facet with this half as its lesser one.
template <int d>
[[nodiscard]] bool has_certificate(const Periodic_table<d>& table, Certificate_id id) {
    if (is_of_cell(id)) return cell_of(id).offset() < table.size();
    const Corner_index f = facet_of(id);
    return table.cell_of(f) < table.size() && f < table.twin[table.cell_of(f)][table.slot_of(f)];
}
/// Its points: the corners of a cell in positive order; of a bi-cell in the order of the predicates, the facet, the
/// corner beyond it, and its own, all as the cell of the lesser half sees them.
template <int d>
[[nodiscard]] std::array<Image<d>, static_cast<std::size_t>(d + 2)> certificate_images(const Periodic_table<d>& table,
                                                                                       Certificate_id id);
/// Calls visit(id) for every certificate of a cell: its own and those of its facets.
template <int d, class Visit>
void for_each_certificate_of_cell(const Periodic_table<d>& table, std::size_t c, Visit visit) {
    visit(periodic_cell_id(c));
    for (std::size_t i = 0; i <= d; ++i) visit(facet_id(table, c, i));
}

/// Evaluates these certificates, which the table must have: out[k] is that of ids[k], whatever the number of threads.
/// Returns how many each stage decided. Precondition: out.size() == ids.size(). Throws bad_alloc.
template <int d>
Stage_counts evaluate_periodic(const Periodic_view<d>& view, std::span<const Certificate_id> ids, int threads,
                               std::span<Evaluated_certificate<d>> out);

extern template std::array<Image<2>, 4> certificate_images(const Periodic_table<2>&, Certificate_id);
extern template std::array<Image<3>, 5> certificate_images(const Periodic_table<3>&, Certificate_id);
extern template Stage_counts evaluate_periodic(const Periodic_view<2>&, std::span<const Certificate_id>, int,
                                               std::span<Evaluated_certificate<2>>);
extern template Stage_counts evaluate_periodic(const Periodic_view<3>&, std::span<const Certificate_id>, int,
                                               std::span<Evaluated_certificate<3>>);

}  // namespace annulus::inline v1
