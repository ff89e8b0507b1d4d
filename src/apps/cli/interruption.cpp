// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/interruption.h>

#include <atomic>

namespace annulus::inline v1::cli {

namespace {

// Atomic, because another thread may receive the signal.
std::atomic<int> noted{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may use lock-free atomics only");

extern "C" void annulus_note_signal(int signal) { noted.store(signal); }

bool watched = false;  // a guard exists

}  // namespace

Interruption_guard::Interruption_guard() noexcept : outermost_(!watched) {
    if (!outermost_) return;
    watched = true;
    struct sigaction note {};
    note.sa_handler = annulus_note_signal;
    note.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
    sigemptyset(&note.sa_mask);
    for (std::size_t i = 0; i < signals.size(); ++i) {
        sigaction(signals[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN) sigaction(signals[i], &note, nullptr);
    }
}

Interruption_guard::~Interruption_guard() {
    if (!outermost_) return;
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
    watched = false;
}

bool Interruption_guard::interrupted() noexcept { return noted.load() != 0; }

void Interruption_guard::end_if_interrupted() noexcept {
    if (noted.load() != 0) raise(noted.load());
}

}  // namespace annulus::inline v1::cli
