// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace annulus::inline v1 {

/// How to treat a file with a periodic box; triangulations here are not periodic.
struct Periodic_box {
    bool ignored = false;        ///< positions are used unchanged, with a note; else an Input_error
    const char* how = "--open";  ///< the option that does so, for the error
};

}  // namespace annulus::inline v1
