// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/certificates.h>
#include <annulus/predicate/sure_orientation.h>

#include <cstdint>
#include <span>
#include <utility>

namespace annulus::inline v1 {

/// A cell that holds p in its interior or on its border; an infinite cell when p is outside the hull. The walk goes
/// from `start` across facets that p is beyond, never back across the last one. The facet that is tested first is
/// drawn at random, but the same in every run. Adds the number of facets crossed to `steps`. With exact signs the walk
/// ends in every Delaunay triangulation.
///
/// A Walker describes what the walk goes through: corners(cell), pointers to the positions of the corners of a finite
/// cell; is_infinite(cell); beyond(cell, slot), the cell across a facet; and inner(cell), the finite neighbour of an
/// infinite cell.
template <int d, class Walker, class Cell>
[[nodiscard]] Cell walk_to(const Walker& on, const Coordinates<d>& p, Cell start, std::size_t& steps) {
    std::uint32_t random = 1;
    Cell from = start;
    Cell c = on.is_infinite(start) ? on.inner(start) : start;
    for (bool inside = false; !inside && !on.is_infinite(c);) {
        inside = true;
        random = random * 1664525U + 1013904223U;
        Tuple<d, d + 1> x = on.corners(c);
        const int first = static_cast<int>((random >> 16) % (d + 1));
        for (int k = 0; inside && k <= d; ++k) {
            const int i = (first + k) % (d + 1);
            const Cell next = on.beyond(c, i);
            if (next == from && !on.is_infinite(next)) continue;
            const Coordinates<d>* const corner = std::exchange(x[static_cast<std::size_t>(i)], &p);
            inside = sure_orientation<d>(x) >= 0;
            x[static_cast<std::size_t>(i)] = corner;
            if (inside) continue;
            from = std::exchange(c, next);
            ++steps;
        }
    }
    return c;
}

/// A Corner_table to walk on, at positions x.
template <int d>
class Table_walker {
  public:
    Table_walker(const Corner_table<d>& t, std::span<const Coordinates<d>> x) : t_(t), x_(x) {}
    [[nodiscard]] bool is_infinite(Cell_index c) const { return t_.is_infinite(c); }
    [[nodiscard]] Cell_index beyond(Cell_index c, int i) const { return t_.cell_of(t_.twin(t_.corner(c, i))); }
    [[nodiscard]] Cell_index inner(Cell_index c) const { return beyond(c, t_.slot_of_infinity(c)); }
    [[nodiscard]] Tuple<d, d + 1> corners(Cell_index c) const { return tuple<d, d + 1>(cell_sites(t_, c), x_); }

  private:
    const Corner_table<d>& t_;
    std::span<const Coordinates<d>> x_;
};

}  // namespace annulus::inline v1
