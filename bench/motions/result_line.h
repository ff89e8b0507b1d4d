// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace bench {

/// Quantile q of the numbers; 0 for an empty list.
[[nodiscard]] inline double quantile(std::vector<double> v, double q) {
    if (v.empty()) return 0.0;
    std::sort(v.begin(), v.end());
    return v[std::min(v.size() - 1, static_cast<std::size_t>(q * static_cast<double>(v.size())))];
}

/// Appends a line to the file, if any.
inline void append(const std::string& file, const nlohmann::ordered_json& line) {
    if (!file.empty()) std::ofstream(file, std::ios::app) << line.dump() << '\n';
}

}  // namespace bench
