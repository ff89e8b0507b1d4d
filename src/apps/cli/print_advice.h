// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/advice_record.h>

namespace annulus::inline v1::cli {

/// Prints the output of `advise` on standard output.
void print_advice(const Advice_record& record);

}  // namespace annulus::inline v1::cli
