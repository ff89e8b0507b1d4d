// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/experiment/coordinator.h>

#include <exception>
#include <functional>
#include <memory>
#include <string>

namespace annulus::inline v1 {

/// The processes of a run under MPI, of which this is one; a single process where it was not started by mpirun, srun or
/// the like. Only the thread that makes the object may use it.
class Ranks {
  public:
    /// Starts MPI if this process was started as one of several. Throws Error(usage) if it was and this build has no
    /// MPI: each process would be a run of its own.
    Ranks();
    /// Ends MPI. Releases the other ranks if they have not received anything yet.
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    [[nodiscard]] static bool built_with_mpi() noexcept;
    [[nodiscard]] int rank() const noexcept { return rank_; }
    [[nodiscard]] int size() const noexcept { return size_; }
    [[nodiscard]] bool first() const noexcept { return rank_ == 0; }
    /// The number of this rank's machine, and the number of ranks on it.
    [[nodiscard]] int machine() const noexcept { return machine_; }
    [[nodiscard]] int ranks_of_machine() const noexcept { return ranks_of_machine_; }

    /// Sends the first rank's argument to all others, whose argument is replaced.
    void share(std::string& text);

    /// For the first rank: answers the others until the sweep is over and all of them have been notified. Calls `poll`
    /// every few milliseconds.
    void serve(Coordinator& coordinator, int threads, const std::function<void()>& poll);
    /// For any other rank: runs the trials that the first hands out, on this many threads, until the first reports the
    /// end.
    void work(const Spec& spec, int threads);
    /// For any other rank that cannot take part or continue: ends the sweep for that reason.
    void give_up(const std::exception_ptr& why);

  private:
    struct Messages;
    std::unique_ptr<Messages> messages_;
    int rank_ = 0, size_ = 1, machine_ = 0, ranks_of_machine_ = 1;
};

}  // namespace annulus::inline v1
