// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace bench {

/// What quantile q of the numbers is; 0 of none.
[[nodiscard]] inline double quantile(std::vector<double> v, double q) {
    if (v.empty()) return 0.0;
    std::sort(v.begin(), v.end());
    return v[std::min(v.size() - 1, static_cast<std::size_t>(q * static_cast<double>(v.size())))];
}

/// Appends a line to the file, if one is named.
inline void append(const std::string& file, const nlohmann::ordered_json& line) {
    if (!file.empty()) std::ofstream(file, std::ios::app) << line.dump() << '\n';
}

}  // namespace bench
