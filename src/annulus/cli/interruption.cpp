// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/interruption.h>

#include <atomic>

namespace annulus::cli {

namespace {

// Another thread may take the signal.
std::atomic<int> noted{0};
static_assert(std::atomic<int>::is_always_lock_free, "a signal handler may use lock-free atomics only");

extern "C" void annulus_note_signal(int signal) { noted.store(signal); }

}  // namespace

Interruption_guard::Interruption_guard() noexcept {
    noted.store(0);
    struct sigaction note {};
    note.sa_handler = annulus_note_signal;
    note.sa_flags = SA_RESTART;
    sigemptyset(&note.sa_mask);
    for (std::size_t i = 0; i < signals.size(); ++i) {
        sigaction(signals[i], nullptr, &before_[i]);
        if (before_[i].sa_handler != SIG_IGN) sigaction(signals[i], &note, nullptr);
    }
}

Interruption_guard::~Interruption_guard() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
    if (noted.load() != 0) raise(noted.load());
}

bool Interruption_guard::interrupted() const noexcept { return noted.load() != 0; }

}  // namespace annulus::cli
