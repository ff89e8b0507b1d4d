// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// A cell of a wide table: its content, HTML, and the number by which it is sorted, where that is not its text.
struct Table_cell {
    std::string html;
    std::optional<double> key{};

    Table_cell(std::string shown, std::optional<double> by = std::nullopt) : html(std::move(shown)), key(by) {}
    Table_cell(const char* shown) : html(shown) {}
};
using Table_row = std::vector<Table_cell>;

/// A wide table that scrolls sideways where the window is narrow. The first cell of a row is its heading. With
/// `sortable` the page sorts the rows by a column when its heading is pressed, least first, and in reverse order when
/// it is pressed again; cells without a number come last.
void append_table(std::string& out, const std::vector<std::string>& head, const std::vector<Table_row>& rows,
                  bool sortable = false);

/// The script that sorts, for the end of a page. It has no effect without a sortable table.
[[nodiscard]] std::string table_script();

}  // namespace annulus::inline v1
