// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <compare>

namespace annulus::inline v1 {

/// A corner of a cell as geometry sees it: a vertex, and which of its images it is. Sites tell corners apart. The
/// conversion from a vertex is explicit, since a vertex alone names no image.
template <class Label>
struct Site_of {
    Index vertex;
    [[no_unique_address]] Label label;

    Site_of() = default;
    explicit constexpr Site_of(Index v, Label l = Label{}) : vertex(v), label(l) {}
    friend constexpr auto operator<=>(const Site_of&, const Site_of&) = default;
};

/// The label where every vertex has one image.
struct No_label {
    friend constexpr auto operator<=>(No_label, No_label) = default;
};

}  // namespace annulus::inline v1
