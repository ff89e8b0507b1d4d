// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/contender.h>
#include <apps/reproduction/scene.h>

#include <functional>
#include <set>
#include <stdexcept>

namespace annulus::inline v1 {

/// What is run on one motion, and measured on the way.
struct Benchmark_plan {
    std::string name;   ///< "lloyd-one": of the benchmark and its files
    std::string title;  ///< for display
    std::uint64_t steps = 0;
    std::vector<Contender_plan> contenders{};
    std::set<std::uint64_t> surveys{}, distributions{}, degeneracies{}, adversaries{}, stabilities{},
        operations{};                    ///< before these steps; steps + 1 is after the last
    std::set<std::uint64_t> pictures{};  ///< after so many steps
    std::uint64_t quality_every = 0;     ///< steps; 0: never
    std::uint64_t attacks = 0;           ///< at most; 0: all
    std::uint64_t seed = 1;
};

/// Thrown when the reproduction is to end early.
struct Benchmark_stopped : std::runtime_error {
    Benchmark_stopped() : std::runtime_error("stopped") {}
};

/// Called with the number of finished steps and a message; returns whether to continue.
using Benchmark_listener = std::function<bool(std::uint64_t step, const std::string& news)>;

/// Computes the motion and lets all contenders follow it. Some steps are recorded at a time, and the contenders follow
/// them in turn, so that each has warm caches and yet all are timed within the same seconds, whatever else the machine
/// does. Throws Benchmark_stopped.
template <int d>
[[nodiscard]] Benchmark_record benchmark(Scene<d>& scene, const Benchmark_plan& plan,
                                         const Benchmark_listener& listener);

extern template Benchmark_record benchmark<2>(Scene<2>&, const Benchmark_plan&, const Benchmark_listener&);
extern template Benchmark_record benchmark<3>(Scene<3>&, const Benchmark_plan&, const Benchmark_listener&);

}  // namespace annulus::inline v1
