// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/builder.h>
#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <cstddef>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Builds periodic Delaunay triangulations from nothing, of any number of points from none on, in any box.
///
///     +---------------+
///     |  . copies  .  |    The points are copied into a collar around the basis' cell and triangulated by Builder.
///     |  +---------+  |    Of the cells, one of each orbit is kept: that whose least image (vertex, offset) is in the
///     |. |  points |. |    basis' cell. Where its neighbour is not the one that is kept, facets are matched by their
///     |  +---------+  |    images up to a translation. The result counts if it is proved (is_proved_delaunay), so it
///     |  .  .   .  .  |    need not be known how wide the collar has to be: it is widened until that is so.
///     +---------------+
///
/// Buffers are kept from one build to the next. One call at a time.
template <int d>
class Periodic_builder {
  public:
    /// Triangulates the points at these places of the lattice, by at most this many threads; at NaN there is no point,
    /// and the vertex is in no cell. Throws
    /// Error(duplicate_point), naming two vertices whose places differ by a vector of the lattice, Error(too_large),
    /// bad_alloc; the table is then unspecified. Expected O(n) for points that are not all on few spheres or curves;
    /// docs/periodic.md has what it costs.
    void build(const Lattice<d>& lattice, std::span<const Coordinates<d>> place, int threads, Periodic_table<d>& table);
    /// How many copies the last build triangulated, and how many it tried.
    [[nodiscard]] std::size_t copies() const { return copy_.size(); }
    [[nodiscard]] int attempts() const { return attempts_; }

  private:
    void copy_into(const Lattice<d>& lattice, std::span<const Coordinates<d>> place, const Coordinates<d>& collar);
    [[nodiscard]] bool triangulate_copies(int threads);
    /// False where the kept cells do not fit together.
    [[nodiscard]] bool keep_one_of_each(Periodic_table<d>& table);
    [[nodiscard]] bool match_facets(Periodic_table<d>& table);

    Builder<d> builder_;
    std::vector<Coordinates<d>> copy_;  // places
    std::vector<Image<d>> image_;       // by copy
    std::vector<Offset<d>> home_;       // by vertex: of the image in the basis' cell
    std::vector<Index> numbers_;        // 0, 1, 2 ..
    Corner_table<d> cells_;             // of the copies, in an order that does not depend on threads
    std::vector<Index> kept_;           // by cell of the copies: its number in the table, or -1
    int attempts_ = 0;
};

extern template class Periodic_builder<2>;
extern template class Periodic_builder<3>;

}  // namespace annulus::inline v1
