// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/launcher_watch.h>

#include <unistd.h>

#include <chrono>

namespace annulus::inline v1 {

namespace {

constexpr std::chrono::milliseconds look_again{100};
constexpr int fault_of_the_machine = 4;  // docs/tool.md

}  // namespace

Launcher_watch::Launcher_watch()
    : thread_([this, launcher = ::getppid()] {
          std::unique_lock lock(mutex_);
          // Orphans are adopted by another process. Does not wait for anything that other threads hold.
          while (!changed_.wait_for(lock, look_again, [this] { return over_; }))
              if (::getppid() != launcher) ::_exit(fault_of_the_machine);
      }) {}

Launcher_watch::~Launcher_watch() {
    const std::lock_guard lock(mutex_);
    over_ = true;
    changed_.notify_all();
}

}  // namespace annulus::inline v1
