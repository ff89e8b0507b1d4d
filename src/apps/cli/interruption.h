// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include <array>

namespace annulus::inline v1::cli {

/// While an object of this class exists, the first SIGHUP, SIGINT or SIGTERM is only recorded; the same signal again
/// ends the process at once, so that a user can always stop it. Signals that were ignored (nohup) stay ignored. A guard
/// inside the scope of another one does nothing.
class Interruption_guard {
  public:
    Interruption_guard() noexcept;
    ~Interruption_guard();
    Interruption_guard(const Interruption_guard&) = delete;
    Interruption_guard& operator=(const Interruption_guard&) = delete;

    /// Whether a signal has arrived.
    [[nodiscard]] static bool interrupted() noexcept;
    /// Ends the process with the recorded signal, as without a handler; returns if there was none.
    static void end_if_interrupted() noexcept;

  private:
    static constexpr std::array<int, 3> signals{SIGHUP, SIGINT, SIGTERM};
    std::array<struct sigaction, 3> before_{};
    bool outermost_;
};

}  // namespace annulus::inline v1::cli
