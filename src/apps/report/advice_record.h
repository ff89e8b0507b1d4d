// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/degeneracy.h>
#include <annulus/types.h>
#include <apps/report/run_record.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// How far points move from one frame to the next, over all points that are in both and all frames, in mean spacings.
/// The jumps of a trajectory that seems wrapped are left out.
struct Displacement_record {
    static constexpr std::array<double, 7> probabilities{0.05, 0.25, 0.5, 0.75, 0.95, 0.99, 1};

    std::uint64_t total = 0;    ///< displacements; the other members have a meaning if there are any
    std::uint64_t at_rest = 0;  ///< of these, exactly 0
    double mean = 0;
    std::array<double, probabilities.size()> quantiles{};  ///< by a histogram of logarithms, within 1 %; the last exact
};

/// Something that happens to a point: an id as it is in the file.
struct Id_event {
    std::uint64_t frame = 0;
    std::string id;
    std::string what;  ///< the id of the point at the same place; "appears", "disappears"; "x", "y", "z"
};

/// A count of events with the first of them.
struct Id_events {
    static constexpr std::size_t most_named = 5;

    std::uint64_t count = 0;
    std::uint64_t frames = 0;  ///< in which there is any
    std::vector<Id_event> first{};
};

/// What a motion contains, as read from its file.
struct Motion_record {
    std::uint64_t frames = 0;
    std::uint64_t least_vertices = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t most_vertices = 0;
    std::array<double, 3> low{}, high{};  ///< box of all points
    double spacing = 0;                   ///< mean spacing: that of replay, of the first frame with points
    /// Distances of the numbers of successive frames.
    std::uint64_t least_distance = std::numeric_limits<std::uint64_t>::max(), most_distance = 0;
    Displacement_record displacement{};
    Id_events duplicates{};  ///< points where another one is, which represents them
    std::uint64_t appeared = 0, disappeared = 0;
    Id_events traffic{};  ///< points that appear or disappear
    Id_events jumps{};    ///< by three quarters of a side of the box or more
    bool wrapped = false;
};

/// What strategies cost in steps of a motion, by counts of work (Move_statistics::cost).
struct Prefix_record {
    std::uint64_t steps = 0;  ///< the other members have a meaning if there are any
    double automatic = 0;     ///< cost of strategy `auto`, in rebuilds per step
    double tolerances = 0;    ///< that of strategy `tolerances`
    Move_counts moves{};      ///< of `auto`
    std::uint64_t flips = 0, rebuild_steps = 0;
};

/// Advice in one sentence, and what it says.
struct Advice {
    std::string strategy;  ///< "auto", "tolerances", "rebuild"
    /// "one frame", "wrapped", "gain", "traffic", "degenerate", "far apart", "costly repair"
    std::string reason;
    std::uint64_t times_as_often = 1;  ///< how much more often to write frames
    std::string sentence;
};

/// The results of `annulus advise` for one file.
struct Advice_record {
    std::string command;
    std::string file;
    Input_record input{};
    int dimension = 2;
    Motion_record motion{};
    std::optional<Degeneracy> degeneracy{};  ///< of the first frame with points; absent where these are flat
    std::uint64_t degeneracy_frame = 0;      ///< its number
    Prefix_record prefix{};
    double seconds_reading = 0, seconds_following = 0, seconds_analysis = 0;
};

}  // namespace annulus::inline v1
