// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <signal.h>

#include <array>

namespace annulus::cli {

/// While one of these lives, SIGHUP, SIGINT and SIGTERM are only noted. Its destructor gives them back their meaning and
/// raises the one that came, if one did: the process ends by it, after whatever was declared later has cleaned up.
/// Signals that were ignored (nohup) stay so. One at a time, and briefly: nobody likes a program that does not stop.
class Interruption_guard {
  public:
    Interruption_guard() noexcept;
    ~Interruption_guard();
    Interruption_guard(const Interruption_guard&) = delete;
    Interruption_guard& operator=(const Interruption_guard&) = delete;

    /// Has a signal come?
    [[nodiscard]] bool interrupted() const noexcept;

  private:
    static constexpr std::array<int, 3> signals{SIGHUP, SIGINT, SIGTERM};
    std::array<struct sigaction, 3> before_{};
};

}  // namespace annulus::cli
