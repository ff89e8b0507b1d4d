// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/finalizing.h>

#include <pthread.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>

namespace annulus::python {

namespace {

std::atomic<int> computing = 0;         // number of threads that compute without the GIL
std::atomic<bool> over = false;         // the interpreter has ended
thread_local int computing_here = 0;    // 1 if this thread is one of them
thread_local bool ends_python = false;  // true in the thread that ends the interpreter

bool finalizing() noexcept {
#if PY_VERSION_HEX >= 0x030D0000
    return Py_IsFinalizing() != 0;
#else
    return _Py_IsFinalizing() != 0;
#endif
}

void enter() noexcept {
    ++computing_here;
    computing.fetch_add(1);
}
void leave() noexcept {
    --computing_here;
    computing.fetch_sub(1);
    computing.notify_all();
}

/// Called at the very end of the interpreter, in the thread that ends it.
void wait_for_others() {
    over = true;
    for (int n = computing; n > computing_here; n = computing) computing.wait(n);
}

// A child of a fork has only the thread that forked, so at most one thread that computes.
[[maybe_unused]] const int children_count_anew = pthread_atfork(nullptr, nullptr, [] { computing = computing_here; });

}  // namespace

void sleep_for_good() noexcept {
    for (;;) (void)pause();
}

bool python_ends_elsewhere() noexcept { return !ends_python && (over || finalizing()); }

Without_gil::Without_gil() {
    if (finalizing()) ends_python = true;  // no other thread can have the GIL now
    enter();
    state_ = PyEval_SaveThread();
}

Without_gil::~Without_gil() {
    leave();
    if (python_ends_elsewhere()) sleep_for_good();
    may_wait_for_gil([this] { PyEval_RestoreThread(state_); });
}

With_gil::With_gil() {
    leave();
    if (python_ends_elsewhere()) sleep_for_good();
    state_ = may_wait_for_gil([] { return PyGILState_Ensure(); });
}

With_gil::~With_gil() {
    PyGILState_Release(state_);
    enter();
    if (!python_ends_elsewhere()) return;
    leave();
    sleep_for_good();
}

void wait_at_the_end() {
    static bool waits = false;
    if (over.exchange(false))
        waits = false;  // the program has started a new interpreter, which has dropped the registered function
    if (waits) return;
    waits = true;
    // If Python cannot register another function, register it for the end of the process: it then runs before the
    // destructors of the static objects that exist now.
    if (Py_AtExit(&wait_for_others) != 0) (void)std::atexit(&wait_for_others);
}

}  // namespace annulus::python
