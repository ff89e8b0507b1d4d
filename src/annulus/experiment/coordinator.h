// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/experiment/schedule.h>
#include <annulus/experiment/journal.h>
#include <annulus/experiment/spec.h>

#include <condition_variable>
#include <cstdint>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

namespace annulus {

/// Hands out the trials of a sweep and keeps what comes back in its journal. All members may be called from several threads at once.
class Coordinator {
  public:
    /// What the journal has is not done again. `threads` and `bytes` are those of each machine.
    Coordinator(const Spec& spec, Journal& journal, int threads, std::uint64_t bytes);

    /// The next one for a thread of that machine; waits while there is no room for any. None when all are taken, or one has failed.
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

/// run(), but an error that names no file says of which trial it is.
[[nodiscard]] Trial_result run_named(const Trial& trial, std::size_t hardest, int threads);

/// Threads of one process that compute what `take` gives them, until it gives nothing: take() -> optional<Job>, done(job, result),
/// failed(job, exception). All three are called from these threads.
class Workers {
  public:
    template <class Take, class Done, class Failed>
    Workers(int threads, const Spec& spec, Take take, Done done, Failed failed) {
        const auto work = [=, &spec] {
            while (const std::optional<Schedule::Job> job = take()) {
                try {
                    done(*job, run_named(spec.trials[job->trial], spec.hardest, job->threads));
                } catch (...) {
                    failed(*job, std::current_exception());
                }
            }
        };
        try {
            for (int i = 0; i < threads; ++i) thread_.emplace_back(work);
        } catch (const std::system_error&) {  // fewer do as well
            if (thread_.empty()) throw;
        }
    }

  private:
    std::vector<std::jthread> thread_;
};

}  // namespace annulus
