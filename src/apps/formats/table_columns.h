// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/format.h>

#include <array>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace annulus::inline v1 {

/// What a column of a table may have.
enum Table_column { frame_column, id_column, x_column, y_column, z_column };
inline constexpr std::array<std::string_view, 5> table_column_names{"frame", "id", "x", "y", "z"};

/// By Table_column, the name of a column in the header of a table, or its number from 1; empty where none is given.
using Column_choice = std::array<std::string, 5>;

/// Reads `id=particle,frame=t,x=POSITION_X,..`. Throws Error(usage) for other keys than frame, id, x, y and z, a key
/// twice, a key without a name, and x without y or z without x.
[[nodiscard]] Column_choice parse_column_choice(std::string_view text);
[[nodiscard]] bool is_empty(const Column_choice& choice);
/// Throws Error(usage) for a choice of columns where the format is not that of tables.
void require_table(Format format, const Column_choice& choice);

/// Where the columns of a table are.
struct Table_columns {
    std::array<std::optional<std::size_t>, 5> at;  ///< by Table_column
    std::size_t all = 0;
    std::string fault{}, expected{};  ///< of the header, where a column is not found, or two of a name are

    [[nodiscard]] bool complete() const { return fault.empty(); }
};

/// Finds columns by their names: those of the choice, the others by names that programs give them, in either case, with
/// blanks, underscores and a unit (x/m, `X [px]`, `y (mm)`) left out. Of several, one that numbers tracks is the id
/// before one called id, one that numbers frames is the frame before a time. If the choice has an x, y and z are taken
/// from the choice only. A table of points needs x and y; its frame is called so, or is beside an id.
[[nodiscard]] Table_columns find_columns(std::span<const std::string_view> header, const Column_choice& choice,
                                         bool motion);

/// Columns by the numbers of the choice, for a table without a header; std::nullopt where it has names, or lacks one
/// that is needed.
[[nodiscard]] std::optional<Table_columns> numbered_columns(const Column_choice& choice, std::size_t all, bool motion);

}  // namespace annulus::inline v1
