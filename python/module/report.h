// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/arrays.h>

#include <annulus/engine/move_report.h>

#include <memory>
#include <utility>
#include <vector>

namespace annulus::python {

/// A Move_report, and the dimension in which it was.
class Report {
  public:
    Report(Move_report report, int d, bool lists_changes);

    [[nodiscard]] const Move_report& numbers() const { return *report_; }
    /// Simplices that came, and that went, (m, d + 1); None where nobody asked for them.
    [[nodiscard]] py::object changed_simplices() const { return simplices(report_->changed); }
    [[nodiscard]] py::object removed_simplices() const { return simplices(report_->gone); }
    [[nodiscard]] py::dict as_dict() const;
    [[nodiscard]] py::str repr() const;
    [[nodiscard]] py::tuple state() const;
    [[nodiscard]] static Report of_state(const py::object& state);

  private:
    [[nodiscard]] py::object simplices(const std::vector<Index>& vertices) const;

    std::shared_ptr<const Move_report> report_;  // without simplices that are not finite
    int d_;
    bool lists_changes_;
};

}  // namespace annulus::python
