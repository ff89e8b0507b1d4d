// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace annulus::inline v1 {

/// While such an object exists, this process ends with the one that started it (mpirun, or the daemon of mpirun or srun
/// on each machine): within a tenth of a second, with status 4 and without a message. A rank that outlives its launcher
/// would wait for ever for ranks that have ended, and MPI libraries treat this case differently. As with SIGKILL, a
/// journal keeps what it has.
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

}  // namespace annulus::inline v1
