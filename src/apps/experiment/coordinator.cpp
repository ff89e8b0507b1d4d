// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/coordinator.h>

#include <apps/formats/decimal.h>
#include <apps/formats/input_error.h>

#include <stdexcept>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace annulus::inline v1 {

namespace {

/// Lines of results are JSON already.
std::string entry_of(std::size_t trial, int rank, const Trial_result& result, const Hard_inputs& hard) {
    std::string text = "{\"trial\":" + std::to_string(trial) + ",\"lines\":[";
    for (std::size_t i = 0; i < result.lines.size(); ++i) {
        if (i > 0) text += ',';
        text += result.lines[i];
    }
    text += "],\"hard\":" + nlohmann::ordered_json(hard.json()).dump();
    using Json = nlohmann::ordered_json;
    const Json cost{{"rank", rank},
                    {"seconds", result.seconds},
                    {"peak_bytes", result.peak_bytes == 0 ? Json() : Json(result.peak_bytes)}};
    text += ",\"cost\":" + cost.dump() + "}";
    return text;
}

constexpr double worth_a_message = 0.05;  // seconds

}  // namespace

Coordinator::Coordinator(const Spec& spec, Journal& journal, int threads, std::uint64_t bytes)
    : spec_(spec),
      journal_(journal),
      entry_(spec.trials.size()),
      hard_(spec.hardest),
      schedule_(spec.trials, open_trials(), threads, bytes) {}

std::vector<std::size_t> Coordinator::open_trials() {
    for (std::size_t i = 0; i < journal_.size(); ++i) {
        const auto json = nlohmann::ordered_json::parse(journal_.entry(i));
        const auto trial = json.at("trial").get<std::size_t>();
        if (trial >= entry_.size() || entry_[trial]) continue;
        entry_[trial] = i;
        ++done_;
        for (const auto& hard : json.at("hard")) hard_.add(hard);
    }
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < entry_.size(); ++i)
        if (!entry_[i]) open.push_back(i);
    return open;
}

void share_memory_pool() noexcept {
#ifdef __GLIBC__
    ::mallopt(M_ARENA_MAX, 1);
#endif
}

Trial_result run_named(const Trial& t, std::size_t hardest, int threads) {
    try {
        return run(t, hardest, threads);
    } catch (const Input_error&) {
        throw;
    } catch (const Error& e) {
        std::string where = "grid " + std::to_string(t.grid + 1) + " (" + shown(t.grid_name) + "), ";
        if (!t.file.empty()) where += shown(t.file);
        else where += t.kind + ", " + counted(t.points, "point") + ", seed " + std::to_string(t.seed);
        if (t.motion) where += ", " + t.motion->name;
        if (t.motion && t.motion->kind == Trial_motion::Kind::generated) where += " " + decimal(t.motion->pace);
        if (t.rounding.kind != Rounding::Kind::plain) where += ", " + t.rounding.name;
        throw Error(e.code(), where + ": " + e.what());
    } catch (const std::runtime_error&) {  // from oneTBB, where the system provides no thread
        if (threads == 1) throw;
    }
    return run_named(t, hardest, 1);
}

std::optional<Schedule::Job> Coordinator::wait_for_job(int machine) {
    std::unique_lock lock(mutex_);
    while (!schedule_.empty()) {
        if (const auto job = schedule_.take(machine)) return job;
        changed_.wait(lock);
    }
    return std::nullopt;
}

std::vector<Schedule::Job> Coordinator::jobs(int machine, int threads_in_all, bool& over) {
    const std::lock_guard lock(mutex_);
    auto jobs = schedule_.take(machine, worth_a_message, threads_in_all);
    over = jobs.empty() && schedule_.empty();
    return jobs;
}

void Coordinator::finish(std::size_t trial, int machine, int rank, const Trial_result& result) {
    const std::lock_guard lock(mutex_);
    schedule_.finish(trial, machine);
    try {
        entry_[trial] = journal_.size();
        journal_.append(entry_of(trial, rank, result, hard_.merge(result.hard)));
        ++done_;
    } catch (...) {  // for example a full disk
        entry_[trial].reset();
        if (!fault_) fault_ = std::current_exception();
        schedule_.clear();
    }
    changed_.notify_all();
}

void Coordinator::fail(std::size_t trial, int machine, std::exception_ptr why) {
    const std::lock_guard lock(mutex_);
    schedule_.finish(trial, machine);
    if (!fault_) fault_ = std::move(why);
    schedule_.clear();
    changed_.notify_all();
}
void Coordinator::stop(std::exception_ptr why) {
    const std::lock_guard lock(mutex_);
    if (!fault_) fault_ = std::move(why);
    schedule_.clear();
    changed_.notify_all();
}
void Coordinator::rethrow() const {
    const std::lock_guard lock(mutex_);
    if (fault_) std::rethrow_exception(fault_);
}

std::size_t Coordinator::done() const {
    const std::lock_guard lock(mutex_);
    return done_;
}
bool Coordinator::over() const {
    const std::lock_guard lock(mutex_);
    return schedule_.empty() && schedule_.running() == 0;
}
void Coordinator::wait(std::chrono::milliseconds most) {
    std::unique_lock lock(mutex_);
    if (schedule_.empty() && schedule_.running() == 0) return;
    changed_.wait_for(lock, most);
}

}  // namespace annulus::inline v1
