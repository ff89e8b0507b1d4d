// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/experiment/trial.h>

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <span>
#include <tuple>
#include <vector>

namespace annulus::inline v1 {

/// Which process runs which trial when: the longest first, so that no process is left with a long one at the end (list
/// scheduling), and on each machine no more at a time than its memory is estimated to hold. A trial that needs more
/// than that runs alone. Results do not depend on the schedule.
class Schedule {
  public:
    struct Job {
        std::size_t trial;
        int threads;  ///< threads that work on it
    };

    /// `open`: the trials to be run. `threads`: the number on each machine; `bytes`: the memory of each machine.
    Schedule(std::span<const Trial> trials, const std::vector<std::size_t>& open, int threads, std::uint64_t bytes);

    /// One trial for a thread of that machine; none where none is left, or none fits into its memory at present.
    [[nodiscard]] std::optional<Job> take(int machine);
    /// Several trials, which together take about this time, but no more than a fair share of the rest among all
    /// threads: short trials are not worth a message each.
    [[nodiscard]] std::vector<Job> take(int machine, double seconds, int threads_in_all);
    void finish(std::size_t trial, int machine);

    /// Whether no trial is left to be taken.
    [[nodiscard]] bool empty() const { return open_.empty(); }
    [[nodiscard]] std::size_t running() const { return running_; }
    /// Drops the trials that have not begun.
    void clear() { open_.clear(); }

  private:
    struct Longest_first {
        bool operator()(const std::pair<double, std::size_t>& l, const std::pair<double, std::size_t>& r) const {
            return l.first != r.first ? l.first > r.first : l.second < r.second;
        }
    };
    std::span<const Trial> trials_;
    std::set<std::pair<double, std::size_t>, Longest_first> open_;
    std::multiset<std::uint64_t> open_bytes_;
    std::map<int, std::uint64_t> used_;  // by machine
    int threads_;
    std::uint64_t bytes_;
    double seconds_left_ = 0;
    std::size_t running_ = 0;
};

}  // namespace annulus::inline v1
