// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/corner_table.h>
#include <apps/motion/cells_3.h>

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A positive cell with its least vertex first and the least of the others second: one of the orders that keep its
/// orientation.
[[nodiscard]] std::array<Index, 4> in_order(std::array<Index, 4> cell);

/// Sorts cells, each `in_order`, of vertices below n. O(n), as few cells have one least vertex.
void sort_cells(std::vector<std::array<Index, 4>>& cells, std::size_t n);

/// The finite cells of a triangulation, `in_order` and sorted, hence in an order that does not depend on history, with
/// their adjacency, their circumcentres, and a flag for those that belong to a domain. Kept from step to step: only
/// what has changed is recomputed.
///
/// Results computed from them in their order are bit for bit the same under every strategy and for any number of
/// threads.
class Kept_cells_3 {
  public:
    /// Reads a table with infinite cells. Its cells are compared with those of the last reading: O(cells) with a small
    /// constant, and O(log cells) for each cell that differs; where many differ, all are sorted and linked again.
    void read(const Corner_table<3>& table, int threads = 1);
    /// Reads a list of the finite cells, positive and in any order. Vertices are below n. O(n).
    void read(std::vector<std::array<Index, 4>> cells, std::size_t n, int threads = 1);
    /// Computes the circumcentres of all cells, and flags like those of `cells_inside`. Keeps the results of cells none
    /// of whose vertices have moved since the last measurement. O(cells).
    void measure(const Domain_3& domain, std::span<const Coordinates<3>> position, int threads = 1);

    [[nodiscard]] const Mesh_cells<3>& cells() const { return cells_; }
    /// After `measure`, for each cell.
    [[nodiscard]] const std::vector<char>& inside() const { return inside_; }
    [[nodiscard]] std::span<const Cell_moment> moments() const { return moment_; }

  private:
    using Cell = std::array<Index, 4>;

    void find_changes(const Corner_table<3>& table);
    void merge(const Corner_table<3>& table);
    void link(const Corner_table<3>& table, Cell_index number);
    [[nodiscard]] Index find(const Cell& cell) const;

    Mesh_cells<3> cells_, before_;          // before_: room for the next ones
    By_cell<Cell> seen_;                    // by number in the table, at the last reading; corners as they stood there
    std::vector<Cell> gone_, fresh_;        // cells that differ, sorted
    std::vector<Cell_index> fresh_number_;  // in the table
    std::vector<Index> new_place_;          // by old place
    std::vector<Cell_moment> moment_, moment_before_;
    std::vector<char> inside_, inside_before_;
    std::vector<char> known_, known_before_;  // whether the two are there
    std::vector<Coordinates<3>> position_;    // where they hold
    const Domain_3* domain_ = nullptr;
    std::vector<char> moved_;
};

}  // namespace annulus::inline v1
