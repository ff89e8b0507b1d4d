// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/formats/xyz_comment.h>

#include <array>
#include <cstdint>

namespace annulus {

/// Where the coordinates stand in rows of XYZ that nothing announces. Taken is only what can be nothing else: a first
/// column is stepped over if it is an element in every row, and numbers beyond x, y and z only where x, y and z
/// cannot be among others.
class Xyz_guess {
  public:
    /// From the first row of a file without counts, `x y [z]`. Any fault is the reader's, at its line.
    static Xyz_guess of_plain(const Line_reader& reader);
    /// From the first row after a count and a comment, `[element] x y [z] ...`.
    static Xyz_guess of_counted(const Line_reader& reader);

    [[nodiscard]] const Xyz_columns& columns() const noexcept { return columns_; }
    /// Looks at another row, the first one too, if it has as many fields as the first.
    void look_at(const Line_reader& reader);
    /// After the last row: fails where the columns may be others than those taken, at the line of the first row.
    void require_clear(const Line_reader& reader) const;
    /// Has the first of three columns integers, while the others have none? Then it may be an id.
    [[nodiscard]] bool x_may_be_an_id() const noexcept;
    /// Was the first column taken for atomic numbers?
    [[nodiscard]] bool numbers_elements() const noexcept { return lead_ == Lead::number; }

  private:
    enum class Lead { nothing, name, number };
    Xyz_guess(const Line_reader& reader, std::size_t first, Lead lead);

    Xyz_columns columns_;
    Lead lead_;
    std::uint64_t first_line_;
    std::uint64_t rows_ = 0;
    std::array<bool, 3> integers_{true, true, true};  ///< of x, y, z: has every row an integer, written as one?
    bool from_0_ = true, from_1_ = true;              ///< does x count the rows?
};

/// Digits alone, a sign before them.
[[nodiscard]] bool is_integer(std::string_view text);

/// `C`, `H_2`, `*`, `13C`; not what a number is in other notations: `1.5D+01`, `0,5`, `1_000`.
[[nodiscard]] bool is_element_name(std::string_view text);

/// Is this how a row of points looks: numbers, two or more, a word may stand before them?
[[nodiscard]] bool looks_like_row(const std::vector<std::string_view>& fields);

}  // namespace annulus
