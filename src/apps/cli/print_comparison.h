// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/run_record.h>

namespace annulus::inline v1::cli {

/// Prints a line for each strategy, the ratios of their times, and whether they agree. Precondition: there is a run.
void print_comparison(const Comparison_record& comparison);

}  // namespace annulus::inline v1::cli
