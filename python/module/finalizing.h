// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Python.h>

#include <exception>
#include <type_traits>

// Threads and the end of the interpreter. While Python ends it gives the GIL to no other thread: a daemon thread that
// requests it is terminated at that point (pthread_exit, which unwinds its stack) or, from Python 3.14 on, sleeps for
// ever. A C++ stack must not be unwound this way, because destructors do not throw: here such a thread sleeps as well.
// And before the process ends, which destroys static objects, the end of Python waits for threads that compute.
namespace annulus::python {

/// Sleeps until the process ends.
[[noreturn]] void sleep_for_good() noexcept;

/// Sleeps for good where the stack is unwound past it by pthread_exit. A handler could not do that: in one that has
/// caught an exception of C++ another kind cannot be caught (libstdc++ terminates), and errors are translated in such
/// handlers. Exceptions of C++ pass.
class Sleeps_when_terminated {
  public:
    Sleeps_when_terminated() = default;
    ~Sleeps_when_terminated() {
        if (!returned_ && std::uncaught_exceptions() == uncaught_) sleep_for_good();
    }
    Sleeps_when_terminated(const Sleeps_when_terminated&) = delete;
    Sleeps_when_terminated& operator=(const Sleeps_when_terminated&) = delete;
    void returned() noexcept { returned_ = true; }

  private:
    int uncaught_ = std::uncaught_exceptions();
    bool returned_ = false;
};

/// Makes a call that may wait for the GIL. The call must not hold objects that have to be destroyed.
template <class Call>
auto may_wait_for_gil(const Call& call) -> decltype(call()) {
    Sleeps_when_terminated guard;
    if constexpr (std::is_void_v<decltype(call())>) {
        call();
        guard.returned();
    } else {
        auto result = call();
        guard.returned();
        return result;
    }
}

/// Releases the GIL as long as this object exists. Precondition of the constructor: this thread holds the GIL.
class Without_gil {
  public:
    Without_gil();
    ~Without_gil();
    Without_gil(const Without_gil&) = delete;
    Without_gil& operator=(const Without_gil&) = delete;

  private:
    PyThreadState* state_;
};

/// Holds the GIL as long as this object exists, between two parts of a computation without the GIL. Precondition: the
/// computation holds no lock that the end of Python may need.
class With_gil {
  public:
    With_gil();
    ~With_gil();
    With_gil(const With_gil&) = delete;
    With_gil& operator=(const With_gil&) = delete;

  private:
    PyGILState_STATE state_;
};

/// Whether another thread is ending Python or has ended it: then no result of this thread can be returned to Python.
[[nodiscard]] bool python_ends_elsewhere() noexcept;

/// Called when the module is created: from now on the end of Python waits for threads that compute.
void wait_at_the_end();

}  // namespace annulus::python
