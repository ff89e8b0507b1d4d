// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/formatted.h>
#include <apps/report/advice.h>
#include <apps/report/walk_ratios.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

namespace {

constexpr double worthwhile = 1.25;  // a gain from which a strategy is advised
constexpr double aim = 3.0;          // the gain that more frames are to reach

unsigned long long whole(std::uint64_t n) { return n; }

/// Points that appear or disappear, per step and point.
double traffic_share(const Motion_record& m) {
    const double stays = static_cast<double>(m.displacement.total), comes = static_cast<double>(m.traffic.count);
    return comes > 0 ? comes / (comes + 2 * stays) : 0;
}

Advice far_apart(const Advice_record& r, double s) {
    const double target = walk_pace_of_gain(r.dimension, aim);
    const auto k = static_cast<std::uint64_t>(std::min(std::ceil(s / target), 1e15));
    return {
        "rebuild", "far apart", k,
        formatted("Rebuild (auto does so by itself here): frames are far apart; written %llu times as often, if points "
                  "move straight on between them, auto would be expected to be %.0f times as fast as rebuilding.",
                  whole(k), aim)};
}

}  // namespace

double degenerate_share(const Advice_record& r) {
    if (!r.degeneracy || r.degeneracy->bicells.least.total == 0) return 0;
    const Width_counts& w = r.degeneracy->bicells.least;
    std::uint64_t count = w.zero;
    for (std::size_t i = 0; i < w.below.size(); ++i)
        if (r.degeneracy->thresholds[i].name == "1e-9") count = w.below[i];
    return static_cast<double>(count) / static_cast<double>(w.total);
}

Advice advice_of(const Advice_record& r) {
    const Motion_record& m = r.motion;
    if (m.frames < 2)
        return {"rebuild", "one frame", 1, "Build the triangulation once: the file has one frame, and nothing moves."};
    const double s = walk_pace(r.dimension, m.displacement.mean);
    const bool measured = r.prefix.steps > 0 && m.frames > 2;  // auto rebuilds the first step whatever it is
    const double expected = m.displacement.total > 0 ? walk_gain(r.dimension, s) : 1;
    const double cost = measured ? r.prefix.automatic : 1 / expected;
    const bool gains = cost * worthwhile <= 1;
    if (m.wrapped)
        return {gains ? "auto" : "rebuild", "wrapped", 1,
                formatted("Unwrap the trajectory, or use a periodic triangulation: points "
                          "jump across the box, which open boundaries take for moves; as it stands, use %s.",
                          gains ? "auto" : "rebuild")};
    if (gains) {
        const bool tolerances = measured && r.prefix.tolerances < 0.9 * cost;
        const double least = tolerances ? r.prefix.tolerances : cost;
        const char* const name = tolerances ? "tolerances" : "auto";
        if (least < 1e-3)
            return {name, "gain", 1, formatted("Use %s: a step costs less than a thousandth of a rebuild.", name)};
        return {name, "gain", 1, formatted("Use %s: a step costs %.2g rebuilds.", name, least)};
    }
    if (traffic_share(m) > 0.1)
        return {
            "rebuild", "traffic", 1,
            formatted("Rebuild: %.0f %% of the points appear or disappear from one frame to the next; check that ids "
                      "stay the same.",
                      100 * traffic_share(m))};
    if (s > walk_pace_of_gain(r.dimension, aim)) return far_apart(r, s);
    if (degenerate_share(r) > 0.05)
        return {
            "rebuild", "degenerate", 1,
            formatted("Rebuild: points move little, but %.0f %% of the bi-cells are degenerate, as in a crystal, and "
                      "rounding or any motion changes them all the time.",
                      100 * degenerate_share(r))};
    return {"rebuild", "costly repair", 1,
            "Rebuild (auto does so by itself here): points move little, but to repair costs as much as to rebuild, as "
            "with points on a sphere or surface."};
}

}  // namespace annulus::inline v1
