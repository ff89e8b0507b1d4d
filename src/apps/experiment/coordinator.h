// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/experiment/journal.h>
#include <apps/experiment/schedule.h>
#include <apps/experiment/spec.h>

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

namespace annulus::inline v1 {

/// Hands out the trials of a sweep and stores their results in its journal. All members may be called from several
/// threads at once.
class Coordinator {
  public:
    /// Trials in the journal are not run again. `threads` and `bytes` are those of each machine.
    Coordinator(const Spec& spec, Journal& journal, int threads, std::uint64_t bytes);

    /// The next trial for a thread of that machine; waits while there is no memory for any. None when all are taken, or
    /// one has failed.
    [[nodiscard]] std::optional<Schedule::Job> wait_for_job(int machine);
    /// For another process: the trials available now (Schedule::take). Sets `over` where there will be no more.
    [[nodiscard]] std::vector<Schedule::Job> jobs(int machine, int threads_in_all, bool& over);
    void finish(std::size_t trial, int machine, int rank, const Trial_result& result);
    /// After an exception of a trial: no more trials are handed out; running ones are finished and kept. `rethrow`
    /// throws the first exception.
    void fail(std::size_t trial, int machine, std::exception_ptr why);
    /// The same for an exception that no trial threw.
    void stop(std::exception_ptr why);
    void rethrow() const;

    [[nodiscard]] std::size_t done() const;
    [[nodiscard]] std::size_t all() const { return spec_.trials.size(); }
    [[nodiscard]] std::size_t most_hardest() const { return spec_.hardest; }
    /// Whether no trial is left and none is running.
    [[nodiscard]] bool over() const;
    /// Waits until a result has come back, at most for this time.
    void wait(std::chrono::milliseconds most);

    /// The entry of each finished trial in the journal.
    [[nodiscard]] const std::vector<std::optional<std::size_t>>& entries() const { return entry_; }
    /// The hardest inputs of all finished trials.
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

/// run(), but an error that names no file names its trial, and one thread is used where no more are available.
[[nodiscard]] Trial_result run_named(const Trial& trial, std::size_t hardest, int threads);

/// To be called before threads of which there are too many allocate or free anything: they share the memory pool of
/// the main thread. Otherwise glibc reserves 64 MB of address space, and 128 at first, for each of up to 8 threads a
/// processor, depending on which of them run at the same time.
void share_memory_pool() noexcept;

/// Threads of one process that run the jobs which `take` returns, until it returns none: take() -> optional<Job>,
/// done(job, result), failed(job, exception). All three are called from these threads. Where the system does not
/// provide so many threads, fewer are used, at most the number of processors, so that resources such as address space
/// remain for their work.
class Workers {
  public:
    template <class Take, class Done, class Failed>
    Workers(int threads, const Spec& spec, Take take, Done done, Failed failed) {
        // No trial begins before the number of threads is known, and before surplus ones have been released.
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
            share_memory_pool();
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

}  // namespace annulus::inline v1
