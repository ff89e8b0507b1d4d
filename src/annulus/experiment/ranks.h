// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/experiment/coordinator.h>

#include <exception>
#include <functional>
#include <memory>
#include <string>

namespace annulus {

/// The processes of a run under MPI, of which this is one; one alone where it was not started by mpirun, srun or the
/// like. Only the thread that makes it may use it.
class Ranks {
  public:
    /// Begins MPI where this process was started as one of several. Throws Error(usage) where it was and this build
    /// has no MPI: it would be one run for each process.
    Ranks();
    /// Ends MPI. Lets the others go where they have not been told anything yet.
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    [[nodiscard]] static bool built_with_mpi() noexcept;
    [[nodiscard]] int rank() const noexcept { return rank_; }
    [[nodiscard]] int size() const noexcept { return size_; }
    [[nodiscard]] bool first() const noexcept { return rank_ == 0; }
    /// Machines are numbered; how many ranks the one of this rank has.
    [[nodiscard]] int machine() const noexcept { return machine_; }
    [[nodiscard]] int ranks_of_machine() const noexcept { return ranks_of_machine_; }

    /// What the first has, all have: of the others' the argument is replaced.
    void share(std::string& text);

    /// Of the first rank: answers the others until the sweep is over and all of them know. `poll` is called every few
    /// milliseconds.
    void serve(Coordinator& coordinator, int threads, const std::function<void()>& poll);
    /// Of any other: computes with so many threads what the first hands out, until it says that is all.
    void work(const Spec& spec, int threads);
    /// Of any other, where it cannot take part or go on: the sweep ends, for that reason.
    void give_up(const std::exception_ptr& why);

  private:
    struct Messages;
    std::unique_ptr<Messages> messages_;
    int rank_ = 0, size_ = 1, machine_ = 0, ranks_of_machine_ = 1;
};

}  // namespace annulus
