// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace annulus {

/// While one lives, this process ends with the one that started it (mpirun, or what it or srun has running on each
/// machine): at once, with status 4 and without a word, a tenth of a second later at the latest. A rank that outlives
/// its launcher waits for others for ever where these have ended, and MPI libraries differ in what they do about it.
/// As with SIGKILL, a journal keeps what it has.
class Launcher_watch {
  public:
    Launcher_watch();
    ~Launcher_watch();
    Launcher_watch(const Launcher_watch&) = delete;
    Launcher_watch& operator=(const Launcher_watch&) = delete;

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool over_ = false;
    std::jthread thread_;
};

}  // namespace annulus
