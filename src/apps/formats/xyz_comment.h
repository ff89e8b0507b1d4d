// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/text_input.h>
#include <apps/motion/file_box.h>

#include <cstdint>
#include <optional>
#include <string>

namespace annulus::inline v1 {

/// The columns of the coordinates in a row of XYZ.
struct Xyz_columns {
    std::size_t all = 0;  ///< fields of every row
    std::size_t x = 0;    ///< the one with x; y and perhaps z follow
    bool has_z = false;
    std::optional<std::size_t> id;  ///< the one with the id, if any
    bool announced = false;         ///< by Properties, else guessed from the first row
};

/// The relevant content of the comment line of extended XYZ.
struct Xyz_comment {
    std::optional<Xyz_columns> columns;  ///< from Properties
    std::string periodic;                ///< "Lattice", "pbc" or "Lattice and pbc", where these declare a periodic box
                                         ///< (in place of Lattice "cell", "box" or i-PI's "CELL(abcABC)")
    std::string vectors{};               ///< the value of Lattice, or of cell or box
    std::string directions{};            ///< the value of pbc
};

/// Reads the reader's line as KEY=VALUE, KEY="VALUE" and words without a value; keys in either case.
///
/// `Properties=NAME:TYPE:WIDTH:...` must have a `pos` of type R or I and width 2 or 3; an `id` is used where it is I:1.
/// Its faults are reported by the reader at this line. Lattice without pbc is periodic; with pbc only where one of its
/// values is true. The same holds for what other programs write instead: `cell` or `box` of 3, 6 or 9 numbers, and
/// `CELL(abcABC): ..`.
[[nodiscard]] Xyz_comment parse_xyz_comment(const Line_reader& reader);

/// The box of a comment that declares a periodic one, in the line where the reader is: three vectors, one after the
/// other, or for `cell` and `box` three lengths; pbc is one value or three. Anything else is a fault of the line: the
/// angles of other programs have no convention.
[[nodiscard]] File_box box_of(const Line_reader& reader, const Xyz_comment& comment);

}  // namespace annulus::inline v1
