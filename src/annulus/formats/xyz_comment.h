// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/formats/text_input.h>

#include <cstdint>
#include <optional>
#include <string>

namespace annulus {

/// Where the coordinates stand among the fields of a row of XYZ.
struct Xyz_columns {
    std::size_t all = 0;  ///< fields that every row has
    std::size_t x = 0;    ///< the one with x; y and perhaps z follow
    bool has_z = false;
    std::optional<std::size_t> id;  ///< the one with the id, where there is one
    bool announced = false;         ///< by Properties, else guessed from the first row
};

/// What the comment line of extended XYZ says that matters here.
struct Xyz_comment {
    std::optional<Xyz_columns> columns;  ///< from Properties
    std::string periodic;  ///< "Lattice", "pbc" or "Lattice and pbc", where these say that space is periodic
                           ///< (in place of Lattice "cell", "box" or i-PI's "CELL(abcABC)")
};

/// Reads the reader's line as KEY=VALUE, KEY="VALUE" and words without a value; keys in either case.
///
/// `Properties=NAME:TYPE:WIDTH:...` must have a `pos` of type R or I and width 2 or 3; an `id` counts where it is
/// I:1. Any fault of it is the reader's at this line. Lattice without pbc is periodic; with pbc, where one of its
/// values is true. So is what other programs write in its place: `cell` or `box` of 3, 6 or 9 numbers, and
/// `CELL(abcABC): ..`.
[[nodiscard]] Xyz_comment parse_xyz_comment(const Line_reader& reader);

}  // namespace annulus
