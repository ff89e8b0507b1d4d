// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/write_csv.h>
#include <apps/report/degeneracy_report.h>

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// A summary of how degenerate one frame of a motion is. Lengths are in mean spacings of the frame.
struct Degeneracy_row {
    /// Of frames that are not flat.
    struct Numbers {
        double spacing = 0;
        std::uint64_t bicells = 0, zero = 0, non_convex = 0, paper_unsound = 0;
        std::vector<std::uint64_t> below;  ///< widths of bi-cells, by threshold
        std::array<double, 3> width{}, tolerance{},
            paper{};  ///< the least, 1 % and half are smaller; tolerances of vertices
        double theta_median = 0;
        bool periodic = false;  ///< nothing is known of the paper's tolerances
    };
    std::uint64_t frame = 0;
    std::uint64_t points = 0, vertices = 0;
    std::optional<Numbers> numbers{};
};

[[nodiscard]] Degeneracy_row degeneracy_row(std::uint64_t frame, const Degeneracy_record& record);

/// The frames of a motion.
struct Degeneracy_series {
    std::string command, file;
    int dimension = 2;
    std::vector<std::string> thresholds;  ///< by name
    std::vector<Degeneracy_row> rows;
    Input_record input{};
};

/// The content of degeneracy.csv: one row per frame; values that flat frames do not have are absent.
[[nodiscard]] Csv_table degeneracy_table(const Degeneracy_series& series);
/// The content of degeneracy.json of a motion: a description of the table.
[[nodiscard]] nlohmann::ordered_json degeneracy_json(const Degeneracy_series& series);
/// The page with its curves.
[[nodiscard]] std::string degeneracy_html(const Degeneracy_series& series);

}  // namespace annulus::inline v1
