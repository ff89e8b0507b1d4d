// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/xyz_comment.h>

#include <array>
#include <cstdint>

namespace annulus::inline v1 {

/// The columns of the coordinates in rows of XYZ without `Properties`. Only unambiguous rows are accepted: a first
/// column is skipped if it is an element in every row, and numbers beyond x, y and z only where no other columns can be
/// x, y and z.
class Xyz_guess {
  public:
    /// From the first row of a file without counts, `x y [z]`. Faults are reported by the reader at its line.
    static Xyz_guess of_plain(const Line_reader& reader);
    /// From the first row after a count and a comment, `[element] x y [z] ...`.
    static Xyz_guess of_counted(const Line_reader& reader);

    [[nodiscard]] const Xyz_columns& columns() const noexcept { return columns_; }
    /// Takes another row into account, the first one too, if it has as many fields as the first.
    void examine(const Line_reader& reader);
    /// After the last row: fails at the line of the first row where the columns may be others than those taken.
    void require_clear(const Line_reader& reader) const;
    /// Whether the first of three columns has integers and the others have none; then it may be an id.
    [[nodiscard]] bool x_may_be_an_id() const noexcept;
    /// Whether the first column was taken as atomic numbers.
    [[nodiscard]] bool numbers_elements() const noexcept { return lead_ == Lead::number; }

  private:
    enum class Lead { nothing, name, number };
    Xyz_guess(const Line_reader& reader, std::size_t first, Lead lead);

    Xyz_columns columns_;
    Lead lead_;
    std::uint64_t first_line_;
    std::uint64_t rows_ = 0;
    std::array<bool, 3> integers_{true, true, true};  ///< of x, y, z: whether every row has an integer, written as one
    bool from_0_ = true, from_1_ = true;              ///< whether x counts the rows
};

/// Digits alone, perhaps after a sign.
[[nodiscard]] bool is_integer(std::string_view text);

/// `C`, `H_2`, `*`, `13C`; not a number in other notations: `1.5D+01`, `0,5`, `1_000`.
[[nodiscard]] bool is_element_name(std::string_view text);

/// Whether this looks like a row of points: two or more numbers, perhaps after a word.
[[nodiscard]] bool looks_like_row(const std::vector<std::string_view>& fields);

}  // namespace annulus::inline v1
