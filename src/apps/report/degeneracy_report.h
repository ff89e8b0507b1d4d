// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/degeneracy.h>
#include <apps/report/run_record.h>

#include <nlohmann/json.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// The results for the points of one file.
struct Degeneracy_record {
    std::string command;
    std::string file;
    Input_record input{};
    int dimension = 2;
    std::uint64_t points = 0;          ///< in the file
    std::uint64_t vertices = 0;        ///< distinct ones
    int affine_dimension = 0;          ///< of the span of the points
    std::uint64_t simplices = 0;       ///< finite simplices of that dimension
    double seconds_triangulation = 0;  ///< building
    double seconds_analysis = 0;
    std::optional<Degeneracy> measured{};  ///< absent where the points are flat
};

/// The content of degeneracy.json: keys in a fixed order; null for values that flat points do not have.
[[nodiscard]] nlohmann::ordered_json degeneracy_json(const Degeneracy_record& record);

/// The content of degeneracy.html: one self-contained page.
[[nodiscard]] std::string degeneracy_html(const Degeneracy_record& record);

}  // namespace annulus::inline v1
