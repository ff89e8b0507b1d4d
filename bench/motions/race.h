// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"
#include "result_line.h"

#include <annulus/engine/options.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace bench {

/// Who runs, and for how long.
struct Race {
    std::vector<std::string> strategies{"auto", "auto:view", "auto:mesh"};  ///< as `follower` names them
    int steps = 24;                                                         ///< that count; fewer where the motion ends
    int warm = 3;                                                           ///< before them
    int threads = 1;
    bool audit = true;
    bool audit_all = false;  ///< after every step that counts, not only the last
};

/// Strategies and CGAL's rebuild on the same time steps, step by step in turn, each of them first at every so many
/// steps: nanoseconds a vertex and step, ratios of the same step and of the sums. `out` gets what came out, and a
/// line is printed that begins with `name`. Returns how many audits failed.
template <int d>
int race(Motion<d>& motion, const Race& race, const std::string& name, nlohmann::ordered_json& out);

extern template int race<2>(Motion<2>&, const Race&, const std::string&, nlohmann::ordered_json&);
extern template int race<3>(Motion<3>&, const Race&, const std::string&, nlohmann::ordered_json&);

}  // namespace bench
