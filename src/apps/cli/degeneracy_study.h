// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <apps/formats/point_ids.h>
#include <apps/report/degeneracy_report.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

/// Each threshold as text, for example "1e-4", and as a number. Throws Error(usage).
[[nodiscard]] std::vector<std::pair<std::string, double>> thresholds_of(const std::vector<std::string>& words);

/// Points to study, distinct; in a box no two images of one another.
template <int d>
struct Studied_points {
    std::string file;
    std::span<const Coordinates<d>> x;
    std::span<const std::uint64_t> id;  ///< of each
    const Point_ids& ids;               ///< the ids as they are written
    const std::optional<Box<d>>& box;   ///< none: boundaries are open
};
struct Study_options {
    int threads = 1;
    std::vector<std::string> thresholds{};  ///< none: the usual ones
    std::string raw{};                      ///< file for all certificates; none: empty
};

/// Triangulates the points, in their box, and counts what is degenerate. Throws Error.
template <int d>
[[nodiscard]] Degeneracy_record study_points(const Studied_points<d>& points, const Study_options& options);

extern template Degeneracy_record study_points(const Studied_points<2>&, const Study_options&);
extern template Degeneracy_record study_points(const Studied_points<3>&, const Study_options&);

}  // namespace annulus::inline v1::cli
