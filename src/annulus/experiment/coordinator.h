// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/experiment/journal.h>
#include <annulus/experiment/schedule.h>
#include <annulus/experiment/spec.h>

#include <algorithm>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <future>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace annulus {

/// Hands out the trials of a sweep and keeps what comes back in its journal. All members may be called from several
/// threads at once.
class Coordinator {
  public:
    /// What the journal has is not done again. `threads` and `bytes` are those of each machine.
    Coordinator(const Spec& spec, Journal& journal, int threads, std::uint64_t bytes);

    /// The next one for a thread of that machine; waits while there is no room for any. None when all are taken, or
    /// one has failed.
    [[nodiscard]] std::optional<Schedule::Job> wait_for_job(int machine);
    /// For another process: what there is at once (Schedule::take). `over` is set where there will be nothing more.
    [[nodiscard]] std::vector<Schedule::Job> jobs(int machine, int threads_in_all, bool& over);
    void finish(std::size_t trial, int machine, int rank, const Trial_result& result);
    /// A trial threw: nothing more is handed out; what runs is finished and kept. The first is what `rethrow` throws.
    void fail(std::size_t trial, int machine, std::exception_ptr why);
    /// The same where no trial is at fault.
    void stop(std::exception_ptr why);
    void rethrow() const;

    [[nodiscard]] std::size_t done() const;
    [[nodiscard]] std::size_t all() const { return spec_.trials.size(); }
    [[nodiscard]] std::size_t most_hardest() const { return spec_.hardest; }
    /// Nothing is left, and nothing runs.
    [[nodiscard]] bool over() const;
    /// Waits until something has come back, or that long.
    void wait(std::chrono::milliseconds most);

    /// Of each trial that is done, where the journal has it.
    [[nodiscard]] const std::vector<std::optional<std::size_t>>& entries() const { return entry_; }
    /// The hardest inputs of all that is done.
    [[nodiscard]] const Hard_inputs& hardest() const { return hard_; }

  private:
    std::vector<std::size_t> open_trials();

    const Spec& spec_;
    Journal& journal_;
    std::vector<std::optional<std::size_t>> entry_;  // by trial
    Hard_inputs hard_;
    std::size_t done_ = 0;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    Schedule schedule_;
    std::exception_ptr fault_;
};

/// run(), but an error that names no file says of which trial it is, and where threads cannot be had one does as well.
[[nodiscard]] Trial_result run_named(const Trial& trial, std::size_t hardest, int threads);

/// Threads of one process that compute what `take` gives them, until it gives nothing: take() -> optional<Job>,
/// done(job, result), failed(job, exception). All three are called from these threads. Where the system does not give
/// so many, fewer do as well: no more then than the machine has processors, so that what they need is left, addresses
/// for one.
class Workers {
  public:
    template <class Take, class Done, class Failed>
    Workers(int threads, const Spec& spec, Take take, Done done, Failed failed) {
        // No trial begins before it is known how many there are, and before what others had is given back.
        std::promise<std::size_t> known;
        std::promise<void> begin;
        const auto work = [=, &spec, count = known.get_future().share(),
                           begun = begin.get_future().share()](std::size_t self) {
            if (self >= count.get()) return;
            begun.wait();
            while (const std::optional<Schedule::Job> job = take()) {
                try {
                    done(*job, run_named(spec.trials[job->trial], spec.hardest, job->threads));
                } catch (...) {
                    failed(*job, std::current_exception());
                }
            }
        };
        thread_.reserve(static_cast<std::size_t>(threads));
        std::exception_ptr refused;
        try {
            while (thread_.size() < static_cast<std::size_t>(threads)) thread_.emplace_back(work, thread_.size());
        } catch (...) {
            refused = std::current_exception();
        }
        const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
        const std::size_t kept = refused ? std::min((thread_.size() + 7) / 8, processors) : thread_.size();
        known.set_value(kept);
        thread_.erase(thread_.begin() + static_cast<std::ptrdiff_t>(kept), thread_.end());
        begin.set_value();
        if (thread_.empty() && refused) std::rethrow_exception(refused);
    }

  private:
    std::vector<std::jthread> thread_;
};

}  // namespace annulus
