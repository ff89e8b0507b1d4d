// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/triangulation/certificates.h>

#include <optional>
#include <span>

namespace annulus {

/// Some cells that fill the place of others: a flip of space, infinity allowed anywhere. Says nothing of positions.
class Flip_3 {
  public:
    [[nodiscard]] std::span<const Index> gone() const { return {gone_.data(), gone_count_}; }
    /// Each with its vertices in positive order, if it is positive.
    [[nodiscard]] std::span<const Cell_points<3>> came() const { return {came_.data(), came_count_}; }

    void take(Index c) { gone_[gone_count_++] = c; }
    void put(const Cell_points<3>& x) { came_[came_count_++] = x; }

  private:
    std::array<Index, 4> gone_{};
    std::array<Cell_points<3>, 4> came_{};
    std::size_t gone_count_ = 0;
    std::size_t came_count_ = 0;
};

// Nothing where the result would not be simplicial, that is, have an edge or a facet twice. O(degree of a vertex).

/// The facet at half-facet h goes, an edge between its opposite vertices comes.
[[nodiscard]] std::optional<Flip_3> flip_2_3(const Cell_table<3>& t, Index h);
/// The edge of corners i and j of cell c, which three cells share, goes; the triangle of the vertices around it comes.
[[nodiscard]] std::optional<Flip_3> flip_3_2(const Cell_table<3>& t, Index c, int i, int j);
/// An edge that four cells share gives way to one of the two others that the four vertices around it allow: the edge of the facet
/// at h that does not contain the vertex of corner k, and the opposite vertices of that facet.
[[nodiscard]] std::optional<Flip_3> flip_4_4(const Cell_table<3>& t, Index h, Index k);

}  // namespace annulus
