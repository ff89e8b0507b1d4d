// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace annulus::inline v1 {

/// The number of threads TBB may use, the calling one included: `wanted`, but no more than the machine runs at once,
/// and 1 if the system gives this process fewer (limits on processes or on address space), where TBB would throw
/// std::runtime_error in the middle of a loop. Determined by starting that many threads, at some ten microseconds
/// each, and ending them. A number that was granted once is not tested again.
[[nodiscard]] int available_threads(int wanted);

}  // namespace annulus::inline v1
