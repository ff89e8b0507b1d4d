// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace annulus::inline v1 {

/// One cell of a table; std::monostate is an absent value.
using Csv_cell = std::variant<std::monostate, double, std::uint64_t, std::int64_t, std::string>;

/// A table with a header. Every row has one cell for each column.
struct Csv_table {
    std::vector<std::string> header;
    std::vector<std::vector<Csv_cell>> rows;
};

/// Appends text, in quotes where RFC 4180 requires it.
void append_csv_text(std::string& out, std::string_view text);

/// The table as comma separated values, a line each (LF). Doubles are the shortest decimals that read back bit for bit;
/// absent values and NaN are empty cells; text is quoted where RFC 4180 requires it. Throws Error(wrong_size) when a
/// row has another length than the header. Linear.
[[nodiscard]] std::string write_csv(const Csv_table& table);

}  // namespace annulus::inline v1
