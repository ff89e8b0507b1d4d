// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/move_report.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/mesh/cell_journal.h>

#include <array>
#include <vector>

namespace annulus {

/// The cells that come and go while it lives. The table writes down what it changes (Cell_journal); cells of lower
/// dimension are listed before and after.
template <int d>
class Cell_changes {
  public:
    /// Both outlive it; x are the positions. O(1), but O(n log n) where all of them lie in a hyperplane.
    Cell_changes(Delaunay_mesh<d>& mesh, std::span<const Coordinates<d>> x, Cell_journal<d>& journal);
    ~Cell_changes() { mesh_.table().tell(nullptr); }
    Cell_changes(const Cell_changes&) = delete;
    Cell_changes& operator=(const Cell_changes&) = delete;

    /// Writes report.changed and report.gone, sorted by their vertices. O(k log k) for k cells that were written to,
    /// or all n.
    void list(std::span<const Coordinates<d>> x, Move_report& report);

  private:
    using Sites = typename Cell_journal<d>::Sites;
    [[nodiscard]] std::vector<Sites> all_cells(std::span<const Coordinates<d>> x) const;

    Delaunay_mesh<d>& mesh_;
    Cell_journal<d>& journal_;
    bool watched_;               ///< the table is: there are cells of dimension d
    std::vector<Sites> before_;  ///< all cells, where it is not
};

extern template class Cell_changes<2>;
extern template class Cell_changes<3>;

}  // namespace annulus
