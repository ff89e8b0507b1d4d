// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>
#include <annulus/options.h>
#include <annulus/predicate/certificate_value.h>
#include <annulus/published/least_tolerance.h>
#include <annulus/types.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Tolerances of the certificates of a Delaunay triangulation (paper 2.2 and 2.3), by kind. `paper` has the standard
/// annulus of every bi-cell and the slabs of the hull, in plain double, and no tolerances of cells, which is unsound
/// in 3D (docs/theory.md 3). `floating` and `certified` have the annuli of all partitions and tolerances of cells,
/// `floating` in plain double.
template <int d>
class Paper_tolerances {
  public:
    Paper_tolerances(const Corner_table<d>& table, Tolerance_kind kind) : table_(table), kind_(kind) {}
    [[nodiscard]] Tolerance_kind kind() const { return kind_; }

    /// Notes in `least` the tolerances at x of all certificates of these cells and of their facets, and counts them.
    /// Cells that are gone or named twice are allowed. O(k log k).
    void note(std::span<const Cell_index> cells, std::span<const Coordinates<d>> x, Least_tolerance& least,
              Move_result& report);
    /// The same for all cells. O(n).
    void note_everything(std::span<const Coordinates<d>> x, Least_tolerance& least, Move_result& report);

  private:
    /// Certificates of one kind that are evaluated together.
    template <std::size_t k>
    struct Batch {
        std::vector<Facet_certificate<d>> certificate;
        std::vector<Tuple<d, static_cast<int>(k)>> tuple;
        void clear() {
            certificate.clear();
            tuple.clear();
        }
    };
    void clear();
    void add_cell(Cell_index c, std::span<const Coordinates<d>> x);
    void add_facet(Corner_index f, std::span<const Coordinates<d>> x);
    [[nodiscard]] double tolerance(const Facet_certificate<d>& f, const Certificate_value& v,
                                   std::span<const Coordinates<d>> x) const;
    template <std::size_t k>
    void evaluate(Batch<k>& batch, std::span<const Coordinates<d>> x, Least_tolerance& least, Move_result& report);

    const Corner_table<d>& table_;
    Tolerance_kind kind_;
    Batch<d + 1> orientations_;
    Batch<d + 2> spheres_;
    std::vector<Certificate_value> values_;
};

extern template class Paper_tolerances<2>;
extern template class Paper_tolerances<3>;

}  // namespace annulus::inline v1
