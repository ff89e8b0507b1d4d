// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/advice_record.h>

#include <nlohmann/json.hpp>

namespace annulus::inline v1 {

/// How often bi-cells are exactly degenerate, or as narrow as 1e-9 mean spacings; 0 where they were not counted.
[[nodiscard]] double degenerate_share(const Advice_record& record);

/// Which strategy is the cheapest by the counts of the first steps, and what could be changed in the file. No clock
/// decides: the same file gives the same advice.
[[nodiscard]] Advice advice_of(const Advice_record& record);

/// The content of advise.json: keys in a fixed order; null for what a file does not have.
[[nodiscard]] nlohmann::ordered_json advice_json(const Advice_record& record);

}  // namespace annulus::inline v1
