// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace annulus::inline v1 {

/// How to treat a file with a periodic box.
struct Periodic_box {
    bool taken = false;          ///< frames have it; a box that cannot be taken is an Input_error; else:
    bool replaced = false;       ///< what the file says of it is not read
    bool ignored = false;        ///< positions are used unchanged, with a note; else an Input_error
    const char* how = "--open";  ///< the option that does so, for the error
};

}  // namespace annulus::inline v1
