// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/degeneracy_series.h>

namespace annulus::inline v1::cli {

/// Prints the output of `degeneracy` on standard output: for one set of points, or for frames a head and one line each.
void print_degeneracy(const Degeneracy_record& record);
void print_degeneracy_head(const Degeneracy_series& series);
void print_degeneracy(const Degeneracy_row& row);

}  // namespace annulus::inline v1::cli
