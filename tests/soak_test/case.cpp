// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a case, and how many points and steps it has.
#include <soak_test/run.h>

#include <algorithm>
#include <cmath>

namespace annulus::soak {

namespace {

using testing::Motion_kind;

/// Whether most vertices leave their tolerance at most steps, or one moves so far that all must be tested.
bool is_rough(Motion_kind kind) {
    switch (kind) {
        case Motion_kind::growth:
        case Motion_kind::jitter:
        case Motion_kind::bursts:
        case Motion_kind::teleports:
        case Motion_kind::oscillation:
        case Motion_kind::cocircular:
        case Motion_kind::sliding:
        case Motion_kind::clusters:
        case Motion_kind::walk_middle:
        case Motion_kind::walk_large: return true;
        default: return false;
    }
}

/// Approximate microseconds per vertex and step.
double cost(const Case& c) {
    const bool plane = c.dimension == 2;
    if (c.setting.periodic) return (plane ? 0.8 : 5) * (is_rough(c.motion) ? 4 : 1);
    switch (c.setting.strategy) {
        case Strategy::tolerances:
        case Strategy::tolerances_each:
        case Strategy::automatic:
        case Strategy::paper:
        case Strategy::paper_hybrid: return plane ? 0.5 : c.motion == Motion_kind::walk_large ? 60 : 6;
        case Strategy::rebuild: return plane ? 0.7 : 9;
        default: return plane ? 1.2 : 70;
    }
}

}  // namespace

std::string Case::name() const {
    return std::string(testing::name_of(motion)) + "/" + std::string(setting.name) + "/" + std::to_string(dimension);
}

void choose_size(Case& c) {
    testing::Random random(c.seed * 7919 + 17);
    // 40 to 400, small ones often.
    if (c.points == 0)
        c.points = static_cast<std::size_t>(std::exp2(testing::between(random, std::log2(40), std::log2(400))));
    if (c.steps > 0) return;
    const bool cheap = !c.setting.periodic &&
                       (c.setting.strategy == Strategy::tolerances || c.setting.strategy == Strategy::tolerances_each ||
                        c.setting.strategy == Strategy::automatic || c.setting.strategy == Strategy::paper);
    c.steps = 50000;
    if (cheap && !is_rough(c.motion)) return;
    const double within_limit = 1e6 / (cost(c) * static_cast<double>(c.points));
    c.steps = static_cast<std::uint64_t>(std::clamp(within_limit, 100.0, 50000.0));
}

}  // namespace annulus::soak
