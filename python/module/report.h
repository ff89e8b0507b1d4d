// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/arrays.h>

#include <annulus/measure/neighbour_changes.h>
#include <annulus/types.h>

#include <memory>
#include <utility>
#include <vector>

namespace annulus::python {

/// MoveResult in Python: a Move_result, and the dimension of its mesh.
class Report {
  public:
    Report(Move_result report, int d, bool lists_changes);

    [[nodiscard]] const Move_result& numbers() const { return *report_; }
    /// Simplices that were created, and that were removed, (m, d + 1). Throw Error(usage) without report_changes.
    [[nodiscard]] py::object changed_simplices() const { return listed(report_->changed); }
    [[nodiscard]] py::object removed_simplices() const { return listed(report_->gone); }
    /// The pairs of vertices that an edge joins since the call, and those that it joined before, (m, 2). Throw the
    /// same.
    [[nodiscard]] py::object edges_made() const;
    [[nodiscard]] py::object edges_broken() const;
    /// Of a report in 2D, (m, 4). Throws the same.
    [[nodiscard]] py::object t1() const;
    [[nodiscard]] py::dict as_dict() const;
    [[nodiscard]] py::str repr() const;
    [[nodiscard]] py::tuple state() const;
    [[nodiscard]] static Report of_state(const py::object& state);

  private:
    [[nodiscard]] py::object listed(const std::vector<Index>& vertices) const;
    /// The same; None without report_changes.
    [[nodiscard]] py::object simplices(const std::vector<Index>& vertices) const;

    /// Throws Error(usage) without report_changes.
    void require_lists() const;
    [[nodiscard]] Edge_changes edges() const;

    std::shared_ptr<const Move_result> report_;     // lists finite simplices only
    std::vector<Index> others_came_, others_gone_;  // what else the lists had: infinite cells, cells of flat sets
    int d_;
    bool lists_changes_;
};

}  // namespace annulus::python
