// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <experimental/simd>

namespace annulus {

/// Several doubles side by side, as many as a register of the target holds: 2 on the x86-64 baseline. Each lane is rounded as a
/// double by itself would be.
using Lanes = std::experimental::native_simd<double>;

}  // namespace annulus
