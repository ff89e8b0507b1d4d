// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/formats/point_ids.h>
#include <apps/formats/table_header.h>

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// A value of the column frame: the number of a frame, which may be written 3.0, or any other number, as of a time.
struct Frame_value {
    bool is_number = true;     ///< a whole number from 0 to 2^64 - 1
    std::uint64_t number = 0;  ///< if so
    double time = 0;           ///< the same, rounded, or the time

    friend bool operator==(const Frame_value& a, const Frame_value& b) {
        return a.is_number && b.is_number ? a.number == b.number : a.time == b.time;
    }
    friend bool operator<(const Frame_value& a, const Frame_value& b) {
        return a.is_number && b.is_number ? a.number < b.number : a.time < b.time;
    }
};

/// The rows of a table after its header, one after the other. Fields are numbers with a decimal point, or where no
/// comma separates them a decimal comma, the same throughout. After the first row, lines that begin with # are rows,
/// but for those at the end of the table that have another number of fields: comments. Rows of a motion whose fields
/// are all empty, as spreadsheets write them, are blank lines.
class Table_rows {
  public:
    /// The reader must outlive it. `motion`: rows have a frame and an id, and a row without coordinates is allowed.
    Table_rows(Line_reader& reader, const Column_choice& choice, bool motion)
        : reader_(reader), choice_(choice), motion_(motion) {}

    /// Advances to the first or the next row; false at the end.
    bool next();

    [[nodiscard]] const Table_header& header() const noexcept { return header_; }
    [[nodiscard]] bool has(Table_column column) const { return header_.columns.at[column].has_value(); }
    [[nodiscard]] std::string_view field(Table_column column) const { return fields_[*header_.columns.at[column]]; }
    [[nodiscard]] const std::vector<std::string_view>& fields() const noexcept { return fields_; }

    [[nodiscard]] Frame_value frame();
    /// Whether the id is an integer, which may be written 3.0. Fails where it is missing, or is a fraction.
    [[nodiscard]] bool has_integer_id() const;
    /// The number of the id. Fails for a word unless ids are words.
    [[nodiscard]] std::uint64_t id(Point_ids& ids);
    /// Whether a number so far had a decimal comma.
    [[nodiscard]] bool has_decimal_comma() const noexcept { return point_ == ','; }
    /// Whether the row of a motion has no coordinates at all: the point is absent from the frame.
    [[nodiscard]] bool is_absent() const;
    /// z is 0 where there is no such column.
    [[nodiscard]] Coordinates<3> position();

  private:
    bool next_line();
    [[nodiscard]] bool is_blank() const;
    double number(std::string_view text, std::string_view what);

    Line_reader& reader_;
    const Column_choice& choice_;
    bool motion_;
    Table_header header_;
    std::vector<std::string_view> fields_;
    bool begun_ = false;
    char point_ = '\0';          ///< the decimal point or comma, once one was met
    std::string text_;           ///< of a number with a decimal comma
    bool has_large_id_ = false;  ///< one that no int64_t is
};

}  // namespace annulus::inline v1
