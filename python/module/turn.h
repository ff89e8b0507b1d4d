// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace annulus::python {

/// A mutex that a child of a fork does not wait for in vain: who holds it is a process, and the thread that does is
/// not in the child.
class Process_mutex {
  public:
    /// Throws std::runtime_error, which is a RuntimeError in Python, where nobody would ever unlock it.
    void lock();
    void unlock() noexcept {
        holder_.store(nobody, std::memory_order_release);
        holder_.notify_one();
    }

  private:
    static constexpr int nobody = 0;
    std::atomic<int> holder_ =
        nobody;  // else a process, counted by forks: what may be held here is held by it or by an ancestor
};

}  // namespace annulus::python
