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
///     |  +---------+  |    Of the cells, one of each orbit is kept: that whose circumcentre is in the basis' cell.
///     |. |  points |. |    Where its neighbour is not the one that is kept, facets are matched by their images up to
///     |  +---------+  |    a translation. The result counts if it is proved (is_proved_delaunay), so it need not be
///     |  .  .   .  .  |    known how wide the collar has to be: it is widened until that is so.
///     +---------------+
///
/// The sphere of a cell that is kept is in the basis' cell and its radius around it, so a collar as wide as the largest
/// radius suffices. In the widest collar (Lattice::reach), cells are kept whose least image (vertex, offset) is in the
/// basis' cell: no circumcentre is needed then, which is far off where a cell is nearly flat.
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
    /// Where a vertex is.
    struct Home {
        Coordinates<d> fraction;  // coordinates in the basis of the image in its cell, at least 0 and below 1
        Offset<d> offset;         // of this image
        bool deep;                // it is in no collar of another basis cell
    };

    void copy_into(const Lattice<d>& lattice, std::span<const Coordinates<d>> place, const Coordinates<d>& collar);
    [[nodiscard]] bool triangulate_copies(int threads);
    /// False where the kept cells do not fit together.
    [[nodiscard]] bool keep_one_of_each(const Lattice<d>& lattice, bool by_centre, Periodic_table<d>& table);
    /// Whether the circumcentre is in the basis' cell: true of one translate of a cell at most, and where all are among
    /// the copies, of exactly one.
    [[nodiscard]] bool has_centre_at_home(const Lattice<d>& lattice,
                                          std::array<Index, static_cast<std::size_t>(d + 1)> copies) const;
    [[nodiscard]] bool match_facets(Periodic_table<d>& table);

    Builder<d> builder_;
    std::vector<Coordinates<d>> copy_;  // places
    std::vector<Image<d>> image_;       // by copy
    std::vector<Home> home_;            // by vertex
    std::vector<Index> numbers_;        // 0, 1, 2 ..
    Corner_table<d> cells_;             // of the copies, in an order that does not depend on threads
    std::vector<Index> kept_;           // by cell of the copies: its number in the table, or -1
    int attempts_ = 0;
};

extern template class Periodic_builder<2>;
extern template class Periodic_builder<3>;

}  // namespace annulus::inline v1
