// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/axis_ticks.h>
#include <apps/report/run_record.h>

#include <string>

namespace annulus::inline v1 {

/// "12 checked, none failed", or "none". HTML.
[[nodiscard]] inline std::string in_words(const Audit_record& record) {
    if (record.checked == 0) return "none";
    const std::string checked = grouped(record.checked) + " checked, ";
    return checked + (record.failed == 0 ? "<span class=\"good\">none failed</span>"
                                         : "<span class=\"bad\">" + grouped(record.failed) + " failed</span>");
}

}  // namespace annulus::inline v1
