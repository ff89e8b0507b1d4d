// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/schedule.h>

#include <algorithm>

namespace annulus::inline v1 {

Schedule::Schedule(std::span<const Trial> trials, const std::vector<std::size_t>& open, int threads,
                   std::uint64_t bytes)
    : trials_(trials), threads_(threads), bytes_(bytes) {
    for (const std::size_t i : open) {
        open_.insert({trials[i].seconds, i});
        open_bytes_.insert(trials[i].bytes);
        seconds_left_ += trials[i].seconds;
    }
}

std::optional<Schedule::Job> Schedule::take(int machine) {
    if (open_.empty()) return std::nullopt;
    std::uint64_t& used = used_[machine];
    const auto fits = [&](std::uint64_t bytes) { return used == 0 || (used <= bytes_ && bytes <= bytes_ - used); };
    if (!fits(*open_bytes_.begin())) return std::nullopt;
    const auto found =
        std::find_if(open_.begin(), open_.end(), [&](const auto& one) { return fits(trials_[one.second].bytes); });
    const std::size_t i = found->second;
    const Trial& t = trials_[i];
    // While the last long trials run, the other threads are idle: they help.
    const bool is_long = t.seconds * threads_ >= seconds_left_ || t.bytes > bytes_ / 2;
    open_.erase(found);
    open_bytes_.erase(open_bytes_.find(t.bytes));
    used += t.bytes;
    seconds_left_ -= t.seconds;
    ++running_;
    return Job{i, is_long ? threads_ : 1};
}

std::vector<Schedule::Job> Schedule::take(int machine, double seconds, int threads_in_all) {
    std::vector<Job> jobs;
    const double fair = std::min(seconds, seconds_left_ / (2 * threads_in_all));
    double taken = 0;
    do {
        const std::optional<Job> job = take(machine);
        if (!job) break;
        jobs.push_back(*job);
        taken += trials_[job->trial].seconds;
    } while (taken < fair);
    return jobs;
}

void Schedule::finish(std::size_t trial, int machine) {
    used_[machine] -= trials_[trial].bytes;
    --running_;
}

}  // namespace annulus::inline v1
