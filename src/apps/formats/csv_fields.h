// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/text_input.h>

#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// Splits a line at separators outside quotes; fields come without surrounding blanks and quotes. Quotes have a meaning
/// only in fields that begin with one. False where one is still open at the end. Where a blank separates, any number of
/// blanks and tabs does.
[[nodiscard]] bool split_csv(std::string_view line, char separator, std::vector<std::string_view>& fields);

/// The separator of the fields of this first line: tab, semicolon, comma or blank, the first of these that it has.
[[nodiscard]] char csv_separator(std::string_view line);

/// Whether all fields are names; some may be empty, as that of the index which pandas writes. A field that begins like
/// a number is not a name, so that `1 2` is not taken as the name of a column.
[[nodiscard]] bool is_csv_header(const std::vector<std::string_view>& fields);

/// Whether a field stands for a value that is not there: it is empty, nan, NA, N/A, null, None or -.
[[nodiscard]] bool is_missing(std::string_view field);

/// Whether these are the same but for capitals; `lower` has none.
[[nodiscard]] bool equals_lower(std::string_view text, std::string_view lower);

/// Advances to the next line that is not blank; false at the end.
bool next_csv_line(Line_reader& reader);

/// A text without the blanks around it.
[[nodiscard]] std::string_view csv_trimmed(std::string_view text);

}  // namespace annulus::inline v1
