// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/available_threads.h>

#include <oneapi/tbb/info.h>

#include <algorithm>
#include <atomic>
#include <future>
#include <system_error>
#include <thread>
#include <vector>

namespace annulus::inline v1 {

int available_threads(int wanted) {
    static std::atomic<int> given{1};
    const int most = std::min(wanted, oneapi::tbb::info::default_concurrency());
    if (most <= given.load(std::memory_order_relaxed)) return std::max(most, 1);
    std::promise<void> all_there;  // no thread ends before all have started; otherwise one could be reused for all
    const std::shared_future<void> end = all_there.get_future().share();
    std::vector<std::jthread> threads;
    threads.reserve(static_cast<std::size_t>(most) - 1);
    bool refused = false;
    try {
        while (static_cast<int>(threads.size()) < most - 1) threads.emplace_back([end] { end.wait(); });
    } catch (const std::system_error&) {
        refused = true;
    } catch (...) {
        all_there.set_value();
        throw;
    }
    all_there.set_value();
    if (refused) return 1;
    given.store(most, std::memory_order_relaxed);
    return most;
}

}  // namespace annulus::inline v1
