// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace annulus::cli {

/// What the process sees to before anything else: standard streams that were closed are opened on nothing, so that no
/// file takes their place; a file that grows too large is an error and no signal; where memory ends GMP throws
/// std::bad_alloc in place of ending the process; and what is not caught is one line and exit status 4.
void prepare_process();

/// Writes out what is left of standard output. Throws std::runtime_error when not all of it arrived.
void finish_output();

}  // namespace annulus::cli
