// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/standard.h>

namespace annulus {

/// How many threads TBB may have, that which calls among them: `wanted`, but no more than the machine runs at once,
/// and 1 where the system gives this process fewer (limits on processes, on addresses). TBB would throw
/// std::runtime_error in the middle of a loop. Found out by starting so many, which cost some ten microseconds each,
/// and ending them; what was once given is not asked for again.
[[nodiscard]] int available_threads(int wanted);

}  // namespace annulus
