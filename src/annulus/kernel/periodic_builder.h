// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/kept_buffers.h>
#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <cstddef>
#include <span>

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
/// Buffers are kept from one build to the next, if they are not freed in between. One call at a time.
template <int d>
class Periodic_builder {
  public:
    Periodic_builder();
    ~Periodic_builder();
    Periodic_builder(const Periodic_builder&) = delete;
    Periodic_builder& operator=(const Periodic_builder&) = delete;

    /// Triangulates the points at these places of the lattice, by at most this many threads; at NaN there is no point,
    /// and the vertex is in no cell. Throws coinciding_images_error, Error(too_large), bad_alloc; the table is then
    /// unspecified. Expected O(n) for points that are not all on few spheres or curves; docs/periodic.md has what it
    /// costs.
    void build(const Lattice<d>& lattice, std::span<const Coordinates<d>> place, int threads, Periodic_table<d>& table);
    /// How many copies the last build triangulated, and how many it tried.
    [[nodiscard]] std::size_t copies() const { return copies_; }
    [[nodiscard]] int attempts() const { return attempts_; }

    /// A time step has ended: the buffers may be freed (Kept_buffers).
    void end_step() noexcept;
    /// Frees the buffers.
    void release() noexcept;
    /// Whether there are any.
    [[nodiscard]] bool holds_buffers() const { return work_.hold_memory(); }

  private:
    struct Work;

    Kept_buffers<Work> work_;
    std::size_t copies_ = 0;
    int attempts_ = 0;
};

extern template class Periodic_builder<2>;
extern template class Periodic_builder<3>;

}  // namespace annulus::inline v1
