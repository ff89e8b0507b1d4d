// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace annulus::inline v1::cli {

/// To be called first. Opens closed standard streams on /dev/null, so that no file gets their descriptors. Makes a file
/// that grows too large an error instead of a signal. Makes GMP throw std::bad_alloc if memory runs out, instead of
/// ending the process. Turns an uncaught exception into one line and exit status 4.
void prepare_process();

/// Flushes standard output. Throws std::runtime_error if not all of it could be written.
void finish_output();

}  // namespace annulus::inline v1::cli
