// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/table_columns.h>
#include <apps/formats/taken_columns.h>
#include <apps/formats/text_input.h>

#include <cstdint>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// What the lines before the first row say about a table.
struct Table_header {
    Table_columns columns;
    char separator = ',';            ///< of the rows
    bool named = false;              ///< whether columns have names; else the first row says how many there are
    bool has_row = false;            ///< whether the reader is at the first row, and `fields` has its fields
    Taken_columns taken{};           ///< the columns that are there, for messages
    std::uint64_t continued = 0;     ///< lines below the header that are parts of it
    std::uint64_t continued_at = 0;  ///< the first of these
};

/// Reads up to the first row. Lines before it are comments, which begin with #, or with %, * or // where these are not
/// followed by numbers alone, and text; the header is the first line of text that names all columns needed, else the
/// last such comment, as NumPy and PeTrack write it. Up to three lines below a header that have as many fields, none of
/// them a number, are parts of it (units, names for people). The separator of the rows may be another than that of the
/// header; a comment whose words are separated by blanks is a header only where rows are separated by blanks or tabs
/// and have as many fields.
///
/// Without a header the columns are those that the choice numbers; in a table of points they are x, y and perhaps z.
/// Every other table is refused.
[[nodiscard]] Table_header read_table_header(Line_reader& reader, const Column_choice& choice, bool motion,
                                             std::vector<std::string_view>& fields);

/// Splits a row into as many fields as the table has columns; a separator may end it. Fails for a quoted field that
/// does not end: fields that continue on the next line are not supported, since reading rows as parts of them, or the
/// other way round, would lose or invent points.
void split_row(const Line_reader& reader, char separator, std::size_t columns, std::vector<std::string_view>& fields);

}  // namespace annulus::inline v1
