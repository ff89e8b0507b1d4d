// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/reproduction/racer.h>
#include <annulus/reproduction/scene.h>

#include <functional>
#include <set>
#include <stdexcept>

namespace annulus {

/// What is to be run on one motion, and looked at on the way.
struct Race_plan {
    std::string name;   ///< "lloyd-one": of the part, of files
    std::string title;  ///< for people
    std::uint64_t steps = 0;
    std::vector<Racer_plan> racers{};
    std::set<std::uint64_t> surveys{}, distributions{}, degeneracies{}, adversaries{}, stabilities{},
        operations{};                    ///< before these steps; steps + 1 is after the last
    std::set<std::uint64_t> pictures{};  ///< after so many steps
    std::uint64_t quality_every = 0;     ///< steps; 0: never
    std::uint64_t attacks = 0;           ///< of an adversary, at most; 0: all
    std::uint64_t seed = 1;
};

/// Somebody wants the reproduction to end early.
struct Race_stopped : std::runtime_error {
    Race_stopped() : std::runtime_error("stopped") {}
};

/// Told how many steps are done and what happens; returns whether to go on.
using Race_listener = std::function<bool(std::uint64_t step, const std::string& news)>;

/// Makes the motion and has everybody follow it. Some steps are recorded at a time, and the racers follow them in
/// turn, so that each has its own caches and yet all are timed within the same seconds, whatever else the machine
/// does. Throws Race_stopped.
template <int d>
[[nodiscard]] Race_record race(Scene<d>& scene, const Race_plan& plan, const Race_listener& listener);

extern template Race_record race<2>(Scene<2>&, const Race_plan&, const Race_listener&);
extern template Race_record race<3>(Scene<3>&, const Race_plan&, const Race_listener&);

}  // namespace annulus
