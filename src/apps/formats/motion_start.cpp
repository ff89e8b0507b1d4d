// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/decimal.h>
#include <apps/formats/motion_start.h>

#include <algorithm>
#include <system_error>

namespace annulus::inline v1 {

namespace {

bool has_one_z(const Frame& frame, const std::filesystem::path& file, const Motion_options& options) {
    std::error_code ignored;
    if (!is_standard_input(file) && std::filesystem::is_regular_file(file, ignored)) return is_flat(file, options);
    const auto& p = frame.position;
    return std::all_of(p.begin(), p.end(), [&](const auto& q) { return q[2] == p.front()[2]; });
}

}  // namespace

Motion_start start_motion(Motion_reader& reader, const std::filesystem::path& file, const Motion_options& options,
                          int dimension) {
    Motion_start start{.dimension = dimension};
    while (reader.next(start.first) && start.first.id.empty()) start.empty.push_back(start.first.number);
    if (dimension != 0) return start;
    start.dimension = reader.has_z() && !has_one_z(start.first, file, options) ? 3 : 2;
    if (start.dimension == 3 || !reader.has_z()) return start;
    start.why = "z is the same everywhere: ";
    append_decimal(start.why, start.first.position.front()[2]);
    return start;
}

}  // namespace annulus::inline v1
