// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// What the header of an array of NumPy says: `{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4, 2), }`.
struct Npy_header {
    std::string type{};  ///< "<f8"
    bool fortran_order = false;
    std::vector<std::uint64_t> shape{};
};

/// The text of a header. Throws Error(bad_input) with what is wrong where it is none.
[[nodiscard]] Npy_header parse_npy_header(std::string_view text);

}  // namespace annulus::inline v1
