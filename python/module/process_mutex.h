// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>

namespace annulus::python {

/// A mutex that a child of a fork does not wait for in vain. Its holder is recorded as a process: if the mutex was held
/// in the parent, the thread that would unlock it does not exist in the child.
class Process_mutex {
  public:
    /// Throws std::runtime_error, a RuntimeError in Python, if no thread of this process could ever unlock it.
    void lock();
    void unlock() noexcept {
        holder_.store(unlocked, std::memory_order_release);
        holder_.notify_one();
    }

  private:
    static constexpr int unlocked = 0;
    std::atomic<int> holder_ = unlocked;  // or a process, numbered by its count of forks: this process or an ancestor
};

}  // namespace annulus::python
