// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <Python.h>

#include <cxxabi.h>

// Threads and the end of the interpreter. Once Python ends it gives the GIL to no other thread: a daemon thread that
// asks for it is ended where it stands (pthread_exit, which unwinds its stack) or, from Python 3.14 on, sleeps for
// ever. A stack of C++ must not be unwound so, since destructors do not throw: such a thread sleeps here, too. And
// before the process goes, which destroys what is static, the end waits for threads that compute.
namespace annulus::python {

/// Sleeps until the process ends.
[[noreturn]] void sleep_for_good() noexcept;

/// Makes a call that may wait for the GIL; what it holds must not need destruction.
template <class Call>
auto may_wait_for_gil(const Call& call) -> decltype(call()) {
#ifdef __GLIBCXX__
    try {
        return call();
    } catch (const abi::__forced_unwind&) {
        sleep_for_good();
    }
#else
    return call();
#endif
}

/// No GIL for as long as this lives. Constructed with the GIL.
class Without_gil {
  public:
    Without_gil();
    ~Without_gil();
    Without_gil(const Without_gil&) = delete;
    Without_gil& operator=(const Without_gil&) = delete;

  private:
    PyThreadState* state_;
};

/// The GIL for as long as this lives, between two parts of a computation that does without. What computes holds no
/// lock then that the end of Python may need.
class With_gil {
  public:
    With_gil();
    ~With_gil();
    With_gil(const With_gil&) = delete;
    With_gil& operator=(const With_gil&) = delete;

  private:
    PyGILState_STATE state_;
};

/// Whether Python is ending, or has ended, in another thread than this: then none of what is computed here can be
/// handed over.
[[nodiscard]] bool python_ends_elsewhere() noexcept;

/// When the module is made: from now on the end of Python waits for threads that compute.
void wait_at_the_end();

}  // namespace annulus::python
