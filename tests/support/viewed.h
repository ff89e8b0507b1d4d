// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// What is behind a Viewed_mesh: an object of its own, or that of a Session_of.

#include <common/oracle_3.h>

#include <optional>

namespace annulus::testing {

template <int d>
struct Viewed {
    using Moving = typename oracle::Space<d>::Moving;
    std::optional<Moving> own;
    Moving& dt;

    explicit Viewed(Moving made) : own(std::move(made)), dt(*own) {}
    explicit Viewed(Moving* of_another) : dt(*of_another) {}
    Viewed(const Viewed&) = delete;
    Viewed& operator=(const Viewed&) = delete;

    [[nodiscard]] auto vertex(Index i) const { return dt.vertex(static_cast<std::size_t>(i)); }
};

}  // namespace annulus::testing
