// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/mesh/change_log.h>
#include <annulus/types.h>

#include <array>
#include <vector>

namespace annulus::inline v1 {

/// Lists the cells that come and go during its lifetime. The table records what it changes (Change_log); cells of
/// lower dimension are listed before and after.
template <int d>
class Cell_changes {
  public:
    /// The mesh and the log must outlive it; x are the positions. O(1), but O(n log n) where all positions lie in a
    /// hyperplane.
    Cell_changes(Delaunay_mesh<d>& mesh, std::span<const Coordinates<d>> x, Change_log<d>& log);
    ~Cell_changes() { mesh_.table().set_observer(nullptr); }
    Cell_changes(const Cell_changes&) = delete;
    Cell_changes& operator=(const Cell_changes&) = delete;

    /// Writes report.changed and report.gone, sorted by their vertices. O(k log k) for k cells that were written, or
    /// for all n.
    void list(std::span<const Coordinates<d>> x, Move_result& report);

  private:
    using Sites = typename Change_log<d>::Sites;
    [[nodiscard]] std::vector<Sites> all_cells(std::span<const Coordinates<d>> x) const;

    Delaunay_mesh<d>& mesh_;
    Change_log<d>& change_log_;
    bool watched_;               ///< whether the table is observed: there are cells of dimension d
    std::vector<Sites> before_;  ///< all cells, where it is not observed
};

extern template class Cell_changes<2>;
extern template class Cell_changes<3>;

}  // namespace annulus::inline v1
