// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>
#include <annulus/mesh/neighbours.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The finite neighbours of every vertex of a 2D triangulation, as in Neighbours_2, kept from step to step:
/// only the lists of vertices whose triangles have changed are read again.
///
/// Lists have one order whatever the history of the triangulation: a cyclic one begins with its least index, an open
/// one after infinity. So results computed from them are bit for bit the same under every strategy.
class Stars_2 {
  public:
    /// Reads a table. Its triangles are compared with those of the last reading: O(cells), and O(degree) for each
    /// vertex of a cell that differs. All lists are empty where the points are on a line, because there are no cells
    /// then.
    void read(const Corner_table<2>& table);
    /// Reads lists, all of them. O(n).
    void read(const Neighbours_2& lists);

    [[nodiscard]] std::size_t size() const { return place_.size(); }
    [[nodiscard]] std::span<const Index> of(std::size_t v) const {
        return {pool_.data() + place_[v].begin, static_cast<std::size_t>(place_[v].size)};
    }
    /// Consecutive neighbours, and last and first, make a triangle with v: it is not on the convex hull.
    [[nodiscard]] bool cyclic(std::size_t v) const { return !place_[v].open; }
    /// The number of readings, and the one in which the list of v was made.
    [[nodiscard]] std::uint64_t readings() const { return readings_; }
    [[nodiscard]] std::uint64_t since(std::size_t v) const { return place_[v].since; }

  private:
    /// Where the list of a vertex is; it has room to grow a little.
    struct Place {
        std::size_t begin = 0;
        std::uint64_t since = 0;
        Index size = 0, room = 0;
        bool open = true;
    };
    using Triangle = std::array<Index, 3>;

    void find_changed(const Corner_table<2>& table);
    void mark(const Triangle& t);
    void put(std::size_t v, bool open, std::size_t start);

    std::vector<Place> place_;    // by vertex
    std::vector<Index> pool_;     // the lists, with gaps
    By_cell<Triangle> triangle_;  // by cell of the table, at the last reading
    std::vector<char> marked_;    // by vertex
    std::vector<Index> changed_;  // vertices
    std::vector<Index> ring_;     // the list being read
    std::uint64_t readings_ = 0;
};

}  // namespace annulus::inline v1
