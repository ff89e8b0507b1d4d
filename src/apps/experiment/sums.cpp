// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/sums.h>

#include <array>

namespace annulus::inline v1 {

namespace {

constexpr std::array common{"grid",   "name",     "kind",   "file", "ignored", "dimension", "box",
                            "points", "rounding", "motion", "pace", "step",    "frame"};

}  // namespace

void Sums::add(const nlohmann::ordered_json& line) {
    nlohmann::ordered_json where;
    for (const char* key : common)
        if (line.contains(key)) where[key] = line[key];
    const auto [at, fresh] = place_.try_emplace(where.dump(), point_.size());
    if (fresh) point_.push_back({std::move(where)});
    point_[at->second].tally += tally_of(line);
}

}  // namespace annulus::inline v1
