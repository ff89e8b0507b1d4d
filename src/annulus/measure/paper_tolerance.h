// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>
#include <annulus/predicate/half_width.h>

#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The result of the comparison with the paper's tolerances.
struct Paper_verdict {
    std::vector<double> tolerance;   ///< by vertex, lower end
    std::vector<double> exact;       ///< by vertex, the least half width of our certificates that contain it, lower end
    std::uint64_t above_exact = 0;   ///< vertices whose tolerance is above the half width of a certificate they are in
    std::uint64_t unsound = 0;       ///< vertices of the certificates counted next
    std::uint64_t certificates = 0;  ///< those with a half width below the tolerances of all their points
    /// Points of these certificates, in the order of the predicates: d + 2 of a bi-cell, d + 1 of a cell or a ridge.
    std::vector<std::vector<Index>> points;
};

/// Compares the paper's tolerances with the half widths of certificates, both enclosed.
///
/// The paper's list: the standard annulus of every finite bi-cell, a slab for every border facet and every hull ridge;
/// nothing for cells. The tolerance of a vertex is the least of those whose points include it. Our list: annuli of
/// bi-cells, cells, ridges; half their width is the least displacement that makes the certificate 0. Only certain
/// differences are counted: one below a unit in the last place, as between equal numbers of two kinds, is not.
template <int d>
class Paper_tolerance {
  public:
    /// `threads`: how many compare; the result does not depend on it.
    Paper_tolerance(const Corner_table<d>& t, std::size_t vertices, int threads)
        : t_(t),
          paper_(t.facet_bound().offset()),
          facet_(t.facet_bound().offset()),
          own_(t.facet_bound().offset(), 0),
          cell_(t.cell_bound().offset()),
          vertices_(vertices),
          threads_(threads) {}

    void note_bicell(Corner_index f, const Bicell_half_widths& h) {
        paper_[f] = h.standard;
        facet_[f] = h.least;
        own_[f] = h.standard_is_least ? 1 : 0;
    }
    void note_ridge(Corner_index f, const Half_width& h) { facet_[f] = h; }
    void note_paper(Corner_index f, const Half_width& h) { paper_[f] = h; }
    void note_cell(Cell_index c, const Half_width& h) { cell_[c] = h; }

    /// To be called after all numbers were noted. Computes with integers where the enclosures do not decide, and keeps
    /// the results.
    [[nodiscard]] Paper_verdict verdict(std::span<const Coordinates<d>> x);

  private:
    void take_least();
    [[nodiscard]] std::vector<double> least_of_all() const;
    template <class Visit>
    void for_each_facet(const Visit& visit) const;
    template <class Visit>
    void for_each_finite_cell(const Visit& visit) const;
    template <class Visit>
    void for_each_certificate(const Visit& visit);
    [[nodiscard]] std::size_t runs() const;
    void refine(std::span<const Coordinates<d>> x);

    const Corner_table<d>& t_;
    By_corner<Half_width> paper_;  // of facets
    By_corner<Half_width> facet_;  // the certificate; none of a border facet
    By_corner<char> own_;          // of a facet: whether its two numbers are the same
    By_cell<Half_width> cell_;
    std::size_t vertices_;
    int threads_;
    std::vector<Half_width> least_;  // by vertex: the paper's tolerance
};

extern template class Paper_tolerance<2>;
extern template class Paper_tolerance<3>;

}  // namespace annulus::inline v1
