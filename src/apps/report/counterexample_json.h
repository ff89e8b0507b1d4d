// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/counterexample.h>

#include <nlohmann/json.hpp>

#include <string>

namespace annulus::inline v1 {

/// The content of counterexample.json: keys in a fixed order.
[[nodiscard]] nlohmann::ordered_json counterexample_json(const Counterexample& result, const std::string& command);

}  // namespace annulus::inline v1
