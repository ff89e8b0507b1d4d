// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contestant.h"

namespace bench {

/// By how many bytes the resident memory of a process grows at most while `make` makes a contestant and it triangulates
/// the points, its input in the form that the library takes included. Measured in a child process, which has run the
/// contestant's code on a few points before. NaN where /proc does not tell or the child fails. Precondition: this
/// process has no other threads.
[[nodiscard]] double peak_memory(Make_contestant make, const Points<3>& x);

}  // namespace bench
