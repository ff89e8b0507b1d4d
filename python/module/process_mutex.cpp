// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/process_mutex.h>

#include <pthread.h>

#include <stdexcept>

namespace annulus::python {

namespace {

int this_process = 1;  // changed only in a child of a fork, which has one thread

[[maybe_unused]] const int counting_forks = pthread_atfork(nullptr, nullptr, [] { ++this_process; });

}  // namespace

void Process_mutex::lock() {
    for (int holder = unlocked; !holder_.compare_exchange_weak(holder, this_process, std::memory_order_acquire);
         holder = unlocked) {
        if (holder != unlocked && holder != this_process)
            throw std::runtime_error("another thread was in a call on this object when this process was forked");
        if (holder != unlocked) holder_.wait(holder);
    }
}

}  // namespace annulus::python
