// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/report/degeneracy_series.h>

namespace annulus::cli {

/// What `degeneracy` says on standard output: of one set of points, or of frames, a head and a line each.
void print_degeneracy(const Degeneracy_record& record);
void print_degeneracy_head(const Degeneracy_series& series);
void print_degeneracy(const Degeneracy_row& row);

}  // namespace annulus::cli
