// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "contestant.h"

namespace bench {

struct First_use {
    double bytes;    ///< by how much the resident memory of a process grows at most; NaN where /proc does not tell
    double seconds;  ///< processor time, in memory that the process has not touched before
};

/// A contestant is made and triangulates the points, in a child process that has run its code on a few points before.
/// Its input in the form that the library takes is a part of it. Both are NaN where the child fails. Precondition: this
/// process has no other threads.
template <int d>
[[nodiscard]] First_use first_use(Make_contestant<d> make, const Points<d>& x);

extern template First_use first_use<2>(Make_contestant<2>, const Points<2>&);
extern template First_use first_use<3>(Make_contestant<3>, const Points<3>&);

/// Processor time of all threads of this process, in case a library starts some.
[[nodiscard]] double processor_seconds();

}  // namespace bench
