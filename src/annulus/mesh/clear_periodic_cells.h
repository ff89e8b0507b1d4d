// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// clear_cells() for cells with offsets: finds those whose certificates all hold by the filter, four at a time.
template <int d>
class Clear_periodic_cells {
  public:
    /// The most threads of find(), 1 at first. Nothing else depends on it.
    void set_threads(int threads) { threads_ = threads; }
    /// Leaves in rest() the cells for which excludes_all() of Circumcircle_2 or Circumsphere_3 is false of the places
    /// opposite to their facets, and some for which it is true: where an offset is none of -1, 0, 1 and 2, and up to
    /// six in 8,192 that are not tested. Precondition: has_fast_clear_cells(). O(number of cells).
    void find(const Periodic_table<d>& table, const Lattice<d>& lattice, std::span<const Coordinates<d>> x);
    /// In ascending order. Valid until the next call of find().
    [[nodiscard]] const std::vector<std::size_t>& rest() const { return rest_; }

  private:
    /// What is found in a run of cells.
    struct Found {
        std::vector<std::size_t> left;  // those that are lifted
        std::vector<std::size_t> rest;
    };

    int threads_ = 1;
    std::vector<std::size_t> rest_;
    std::vector<Found> found_;          // by run
    std::vector<std::uint8_t> lifted_;  // by cell: whether an offset of it or of a neighbour is not 0
};

extern template class Clear_periodic_cells<2>;
extern template class Clear_periodic_cells<3>;

}  // namespace annulus::inline v1
