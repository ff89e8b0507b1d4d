// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/experiment/sums.h>

#include <nlohmann/json.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// A row of the table on the page of a sweep, by its number from 1.
struct Sweep_row {
    std::size_t number;
    const Grid_point* point;
};

/// "jittered, 3D, 1,000, decimal:3, walk 0.01, step 10": what the placements of a grid point have in common; text.
[[nodiscard]] std::string label_of(const nlohmann::ordered_json& where);

/// The distributions of widths and tolerances of rows in one space, seven of them at most, for the page.
void append_distributions(std::string& out, const std::vector<Sweep_row>& rows, const std::string& heading);

/// Which stages of arithmetic decided certificates of which theta and width; a sentence where it was always the filter.
/// `periodic`: widths are in spacings of the grids of boxes.
void append_stages(std::string& out, const Tally& tally, const std::string& heading, bool periodic);

}  // namespace annulus::inline v1
