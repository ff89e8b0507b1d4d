// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"
#include "result_line.h"

#include <annulus/options.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace bench {

/// The contenders, and the length of the run.
struct Comparison {
    std::vector<std::string> strategies{"auto", "auto:view", "auto:mesh"};  ///< names as in `follower`
    int steps = 24;                                                         ///< timed ones; fewer where the motion ends
    int warm = 3;                                                           ///< before them
    int threads = 1;
    bool audit = true;
    bool audit_all = false;  ///< after every timed step, not only the last
    bool each_step = false;  ///< whether the seconds of each step are written, too
};

/// Strategies and CGAL's rebuild on the same time steps, step by step in turn, each of them first at every so many
/// steps: nanoseconds per vertex and step, ratios of the same step and of the sums. Writes the results to
/// `out`, and prints a line that begins with `name`. Returns the number of failed audits.
template <int d>
int compare(Motion<d>& motion, const Comparison& comparison, const std::string& name, nlohmann::ordered_json& out);

extern template int compare<2>(Motion<2>&, const Comparison&, const std::string&, nlohmann::ordered_json&);
extern template int compare<3>(Motion<3>&, const Comparison&, const std::string&, nlohmann::ordered_json&);

}  // namespace bench
