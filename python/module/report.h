// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/arrays.h>

#include <annulus/engine/move_report.h>

#include <memory>
#include <utility>

namespace annulus::python {

/// A Move_report, and the dimension in which it was.
class Report {
  public:
    Report(Move_report report, int d, bool lists_changes);

    [[nodiscard]] const Move_report& numbers() const { return *report_; }
    /// Simplices that may be new, (m, d + 1); None where nobody asked for them.
    [[nodiscard]] py::object changed_simplices() const;
    [[nodiscard]] py::dict as_dict() const;
    [[nodiscard]] py::str repr() const;
    [[nodiscard]] py::tuple state() const;
    [[nodiscard]] static Report of_state(const py::tuple& state);

  private:
    std::shared_ptr<const Move_report> report_;  // without simplices that are not finite
    int d_;
    bool lists_changes_;
};

}  // namespace annulus::python
