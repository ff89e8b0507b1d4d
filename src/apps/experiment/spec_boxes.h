// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/experiment/spec_reader.h>
#include <apps/motion/crystal.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Where points of a [[grid]] are.
struct Spec_space {
    int dimension = 2;
    std::vector<double> box{};  ///< the numbers of a periodic box (formats/given_box.h); none: boundaries are open
};

/// Those that the key `box` names, a text as that of the option --box, or a list; none without it. Throws Input_error.
[[nodiscard]] std::vector<Spec_space> boxes_of(const Spec_table& table);

/// Throws Input_error where a crystal does not fill one of the spaces with one of the numbers of points.
void require_crystal_fits(const Spec_table& table, const std::pair<std::string, Crystal>& crystal,
                          const std::vector<Spec_space>& spaces, const std::vector<std::uint64_t>& points);

}  // namespace annulus::inline v1
