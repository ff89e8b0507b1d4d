// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

namespace annulus::inline v1 {

/// The vertex info of a triangulation without any.
struct No_info {};

}  // namespace annulus::inline v1
