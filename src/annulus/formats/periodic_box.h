// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

namespace annulus {

/// What to do where a file says that space is periodic, which triangulations here are not.
struct Periodic_box {
    bool ignored = false;        ///< points are taken as they stand, and a note says so; else an Input_error
    const char* how = "--open";  ///< how the caller says so, for the error
};

}  // namespace annulus
