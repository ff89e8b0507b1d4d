// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Pairs of vertices, the smaller index first, ascending.
using Vertex_pairs = std::vector<std::pair<Index, Index>>;

/// The edges of these cells, d + 1 vertices each, each edge once. Infinite vertices and `none` have no edges.
template <int d>
[[nodiscard]] Vertex_pairs edges_of_cells(std::span<const Index> cells);

/// The edges that one call made and broke, from the cells that came and went (Move_result::changed and gone): see
/// Neighbour_changes.
struct Edge_changes {
    Vertex_pairs made, broken;
};
template <int d>
[[nodiscard]] Edge_changes edge_changes(std::span<const Index> came, std::span<const Index> gone);

extern template Vertex_pairs edges_of_cells<2>(std::span<const Index>);
extern template Vertex_pairs edges_of_cells<3>(std::span<const Index>);
extern template Edge_changes edge_changes<2>(std::span<const Index>, std::span<const Index>);
extern template Edge_changes edge_changes<3>(std::span<const Index>, std::span<const Index>);

/// Two points that became neighbours, or no longer are.
struct Neighbour_change {
    std::uint64_t first = 0, second = 0;  ///< ids, first < second
    bool made = false;

    friend bool operator==(const Neighbour_change&, const Neighbour_change&) = default;
};

/// Pairs of points that became neighbours or ceased to be, from the cells that were added and removed
/// (Move_result::changed and gone). An edge of a removed cell still exists if and only if an added cell has it: where
/// some cells around an edge are removed and others stay, an added cell is next to one that stays. So unchanged cells
/// are not read. In 2D a flip is one pair broken and one made, a T1 transition.
///
/// Between two calls of take() a pair that was made and broken again does not count. Points have ids, which outlive
/// their indices.
template <int d>
class Neighbour_changes {
  public:
    /// From now on vertex v is the point of this id.
    void name(Index v, std::uint64_t id);
    /// Records one call of the triangulation: d + 1 vertices per cell. Infinite cells are required, cells with `none`
    /// are allowed. O(k log k) for k cells.
    void note(std::span<const Index> came, std::span<const Index> gone);
    /// The changes since the last call of take(), by ids.
    [[nodiscard]] std::vector<Neighbour_change> take();

  private:
    void enter(const Vertex_pairs& edges, int sign);

    struct Signed {
        std::pair<std::uint64_t, std::uint64_t> pair;
        int sign;
    };
    std::vector<std::uint64_t> id_;
    std::vector<Signed> changes_;
};

extern template class Neighbour_changes<2>;
extern template class Neighbour_changes<3>;

}  // namespace annulus::inline v1
