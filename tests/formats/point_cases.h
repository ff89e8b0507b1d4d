// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Files of points that are read or refused.
#include "expect_fault.h"
#include "temporary_directory.h"

#include <apps/formats/read_points.h>

#include <string>
#include <string_view>
#include <vector>

namespace annulus_test {

using namespace annulus;

using Points_2 = std::vector<Coordinates<2>>;
using Points_3 = std::vector<Coordinates<3>>;
using Lines = std::vector<std::uint64_t>;

/// Refuses `content` under `name` at `line`, read in dimension d.
template <int d>
void refuse(const std::string& name, std::string_view content, std::uint64_t line, const std::string& fault,
            Error_code code = Error_code::bad_input) {
    const Temporary_directory directory;
    expect_fault(
        directory.file(name, content), line, fault, [](const auto& file) { (void)read_points<d>(file); }, code);
}

template <int d>
Point_file<d> accept(const std::string& name, std::string_view content, const Read_options& options = {}) {
    const Temporary_directory directory;
    return read_points<d>(directory.file(name, content), options);
}

}  // namespace annulus_test
