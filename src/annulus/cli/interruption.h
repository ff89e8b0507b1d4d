// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include <array>

namespace annulus::cli {

/// While one of these lives, the first SIGHUP, SIGINT or SIGTERM is only noted; the same signal again ends the
/// process at once: a program has to stop when it is told twice. Signals that were ignored (nohup) stay so. Inside of
/// another one it does nothing.
class Interruption_guard {
  public:
    Interruption_guard() noexcept;
    ~Interruption_guard();
    Interruption_guard(const Interruption_guard&) = delete;
    Interruption_guard& operator=(const Interruption_guard&) = delete;

    /// Has a signal come?
    [[nodiscard]] static bool interrupted() noexcept;
    /// Ends the process by the signal that was noted, as without a handler; returns if there was none.
    static void end_if_interrupted() noexcept;

  private:
    static constexpr std::array<int, 3> signals{SIGHUP, SIGINT, SIGTERM};
    std::array<struct sigaction, 3> before_{};
    bool outermost_;
};

}  // namespace annulus::cli
