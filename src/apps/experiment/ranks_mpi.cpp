// SPDX-License-Identifier: GPL-3.0-or-later
// Several processes, in a build with MPI (ranks_alone.cpp is the other).
#include <apps/experiment/ranks.h>

#include <annulus/error.h>
#include <apps/experiment/launched.h>
#include <apps/experiment/launcher_watch.h>
#include <apps/experiment/packing.h>

#include <mpi.h>

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <deque>
#include <exception>
#include <limits>
#include <map>
#include <mutex>
#include <set>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

namespace {

/// The kind of a message.
enum Tag : int {
    request,  ///< to the first: a request for jobs
    give,     ///< from the first: jobs, or "over"
    result,   ///< to the first: the result of one
    fault,    ///< to the first: the exception of one
    gone,     ///< to the first: why this rank stops
};
constexpr std::string_view over = "over";
// MPI's own calls spin while they wait; the processor is needed by the computing threads.
constexpr std::chrono::milliseconds nap{1}, wait_for_room{20};

/// Shared by the computing threads of a rank and the thread that communicates with the first rank.
struct Shared_state {
    std::mutex mutex{};
    std::condition_variable changed{};
    std::deque<Schedule::Job> waiting{};
    std::vector<std::pair<Tag, std::string>> outbox{};
    std::size_t running = 0;
    bool closed = false;
};

}  // namespace

struct Ranks::Messages {
    Launcher_watch watch{};
    std::vector<int> machines{};  ///< by rank
    bool shared = false;
    std::set<int> notified{};                      ///< the other ranks that were notified of the end or have stopped
    std::map<int, std::set<std::size_t>> doing{};  ///< the trials that they were given

    static void send(int to, Tag tag, std::string_view text) {
        if (text.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
            throw Error(Error_code::too_large,
                        "a result of more than two gigabytes cannot be sent; keep fewer 'hardest' inputs");
        MPI_Send(text.data(), static_cast<int>(text.size()), MPI_CHAR, to, tag, MPI_COMM_WORLD);
    }
    /// The next message, if any.
    static bool receive(int& from, Tag& tag, std::string& text) {
        int there = 0, size = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
        if (there == 0) return false;
        MPI_Get_count(&status, MPI_CHAR, &size);
        text.resize(static_cast<std::size_t>(size));
        from = status.MPI_SOURCE;
        tag = static_cast<Tag>(status.MPI_TAG);
        MPI_Recv(text.data(), size, MPI_CHAR, from, tag, MPI_COMM_WORLD, MPI_STATUS_IGNORE);
        return true;
    }
    /// Without a sweep: answers every request with "over".
    void dismiss(int others) {
        int from = 0;
        Tag tag{};
        std::string text;
        while (std::cmp_less(notified.size(), others)) {
            if (!receive(from, tag, text)) std::this_thread::sleep_for(nap);
            else if (tag == request) send(from, give, over);
            if (tag == request || tag == gone) notified.insert(from);
        }
    }
};

Ranks::Ranks() {
    const int launched = launched_processes();
    if (launched == 1) return;
    int provided = 0;
    messages_ = std::make_unique<Messages>();  // its watch must observe the launcher from here on
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    if (size_ == 1) {
        MPI_Finalize();
        messages_.reset();
        throw Error(
            Error_code::usage,
            "started as one of " + std::to_string(launched) +
                " processes, of which MPI has only this one: each would run all of the sweep (srun: try --mpi=pmix)");
    }
    MPI_Comm here;
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, rank_, MPI_INFO_NULL, &here);
    MPI_Comm_size(here, &ranks_of_machine_);
    machine_ = rank_;
    MPI_Bcast(&machine_, 1, MPI_INT, 0, here);  // a machine is numbered by its first rank
    MPI_Comm_free(&here);
    messages_->machines.resize(static_cast<std::size_t>(size_));
    MPI_Allgather(&machine_, 1, MPI_INT, messages_->machines.data(), 1, MPI_INT, MPI_COMM_WORLD);
}

Ranks::~Ranks() {
    if (!messages_) return;
    std::string nothing;
    if (!messages_->shared) share(nothing);
    else if (first()) messages_->dismiss(size_ - 1);
    MPI_Finalize();
}

bool Ranks::built_with_mpi() noexcept { return true; }

void Ranks::share(std::string& text) {
    if (!messages_) return;
    messages_->shared = true;
    if (text.empty())  // ranks that get nothing send no requests
        for (int other = 1; other < size_; ++other) messages_->notified.insert(other);
    std::uint64_t size = text.size();
    MPI_Bcast(&size, 1, MPI_UINT64_T, 0, MPI_COMM_WORLD);
    text.resize(size);
    if (size > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
        throw Error(Error_code::too_large, "a specification of more than two gigabytes");
    MPI_Bcast(text.data(), static_cast<int>(size), MPI_CHAR, 0, MPI_COMM_WORLD);
}

void Ranks::serve(Coordinator& c, int threads, const std::function<void()>& poll) {
    if (!messages_) return;
    int from = 0;
    Tag tag{};
    std::string text;
    while (!c.over() || std::cmp_less(messages_->notified.size(), size_ - 1)) {
        poll();
        if (!Messages::receive(from, tag, text)) {
            std::this_thread::sleep_for(nap);
            continue;
        }
        const int machine = messages_->machines[static_cast<std::size_t>(from)];
        if (tag == request) {
            bool last = false;
            const auto jobs = c.jobs(machine, threads * size_, last);
            Messages::send(from, give, last ? std::string(over) : packed(jobs));
            if (last) messages_->notified.insert(from);
            for (const auto& job : jobs) messages_->doing[from].insert(job.trial);
        } else if (tag == result) {
            std::size_t trial = 0;
            const Trial_result r = result_of(text, c.most_hardest(), trial);
            messages_->doing[from].erase(trial);
            c.finish(trial, machine, from, r);
        } else if (tag == fault) {
            std::string_view rest(text);
            const std::size_t trial = std::stoull(next_line(rest));
            messages_->doing[from].erase(trial);
            c.fail(trial, machine, fault_of(rest));
        } else {
            for (const std::size_t trial : std::exchange(messages_->doing[from], {}))
                c.fail(trial, machine, fault_of(text));
            c.stop(fault_of(text));
            messages_->notified.insert(from);
        }
    }
}

void Ranks::give_up(const std::exception_ptr& why) {
    if (messages_) Messages::send(0, gone, packed(why));
}

void Ranks::work(const Spec& spec, int threads) {
    if (!messages_) return;
    Shared_state state;
    const auto leave = [&state](Tag tag, std::string text) {
        const std::lock_guard lock(state.mutex);
        state.outbox.emplace_back(tag, std::move(text));
        --state.running;
        state.changed.notify_all();
    };
    const Workers workers(
        threads, spec,
        [&state]() -> std::optional<Schedule::Job> {
            std::unique_lock lock(state.mutex);
            state.changed.wait(lock, [&state] { return state.closed || !state.waiting.empty(); });
            if (state.waiting.empty()) return std::nullopt;
            const auto job = state.waiting.front();
            state.waiting.pop_front();
            ++state.running;
            return job;
        },
        [&leave](const Schedule::Job& job, const Trial_result& r) { leave(result, packed(job.trial, r)); },
        [&leave](const Schedule::Job& job, const std::exception_ptr& why) {
            leave(fault, std::to_string(job.trial) + "\n" + packed(why));
        });

    // Runs before the threads are joined, whatever happens.
    struct Closing {
        Shared_state& state;
        ~Closing() {
            const std::lock_guard lock(state.mutex);
            state.closed = true;
            state.changed.notify_all();
        }
    } const closing{state};

    int from = 0;
    Tag tag{};
    std::string text;
    bool requested = false, over_yet = false;
    std::size_t last_batch = 0;
    auto again = std::chrono::steady_clock::now();
    while (true) {
        std::unique_lock lock(state.mutex);
        for (auto& [what, content] : std::exchange(state.outbox, {})) {
            lock.unlock();
            Messages::send(0, what, content);
            lock.lock();
        }
        const bool idle =
            state.waiting.empty() && (state.running < static_cast<std::size_t>(threads) || last_batch > 1);
        if (over_yet && state.waiting.empty() && state.running == 0 && state.outbox.empty()) return;
        lock.unlock();
        if (!over_yet && !requested && idle && std::chrono::steady_clock::now() >= again) {
            Messages::send(0, request, "");
            requested = true;
        }
        if (Messages::receive(from, tag, text)) {
            requested = false;
            lock.lock();
            if (text == over) {
                over_yet = true;
            } else {
                const auto jobs = jobs_of(text);
                last_batch = jobs.size();
                state.waiting.insert(state.waiting.end(), jobs.begin(), jobs.end());
                if (jobs.empty()) again = std::chrono::steady_clock::now() + wait_for_room;
            }
            state.changed.notify_all();
            continue;
        }
        lock.lock();
        if (state.outbox.empty()) state.changed.wait_for(lock, nap);
    }
}

}  // namespace annulus::inline v1
