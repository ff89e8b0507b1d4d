// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/audit.h>

#include <pybind11/pybind11.h>

namespace annulus::python {

/// The result of an audit as the values of annulus.AuditResult.
[[nodiscard]] pybind11::tuple audit_tuple(const Audit_result& a);

}  // namespace annulus::python
