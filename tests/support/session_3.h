// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A moving 3D triangulation with a model of its required state after every call: the one of the fuzz targets.

#include "../../fuzz/common/program.h"

#include <support/point_sets_3.h>

namespace annulus::testing {

using Cell_list_3 = oracle::Cells_of<3>;
using oracle::cells_of;
using oracle::Operation_3;
using oracle::Program_3;
using oracle::run;
using oracle::Session_3;

}  // namespace annulus::testing
