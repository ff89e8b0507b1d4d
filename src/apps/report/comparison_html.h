// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/run_record.h>

#include <string>

namespace annulus::inline v1 {

/// The part of a page on several strategies: whether they agree, which was fastest, a table and curves. HTML.
void append_comparison(std::string& out, const Comparison_record& comparison);

}  // namespace annulus::inline v1
