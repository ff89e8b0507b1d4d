// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <unistd.h>

#include <atomic>
#include <stdexcept>

namespace annulus::python {

/// A mutex that a child of a fork does not wait for in vain: who holds it is a process, and the thread that does is not in the child.
class Turn {
  public:
    /// Throws std::runtime_error, which is a RuntimeError in Python, where nobody would ever unlock it.
    void lock() {
        const pid_t process = getpid();
        for (pid_t holder = 0; !holder_.compare_exchange_weak(holder, process, std::memory_order_acquire); holder = 0) {
            if (holder != 0 && holder != process)
                throw std::runtime_error("another thread was in a call on this object when this process was forked");
            if (holder != 0) holder_.wait(holder);
        }
    }
    void unlock() noexcept {
        holder_.store(0, std::memory_order_release);
        holder_.notify_one();
    }

  private:
    std::atomic<pid_t> holder_ = 0;  // 0 when nobody does
};

}  // namespace annulus::python
