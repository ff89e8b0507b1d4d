// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/builder.h>
#include <annulus/mesh/periodic_journal.h>
#include <annulus/mesh/periodic_region.h>
#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>
#include <annulus/types.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A triangulation in a periodic box, and what it is of.
template <int d>
struct Periodic_scene {
    Periodic_table<d>& table;
    const Lattice<d>& lattice;
    std::span<const Coordinates<d>> place;   ///< by vertex
    Periodic_journal<d>* journal = nullptr;  ///< keeps what changes, with flags, where there is one
};

/// What became of a point that was to be inserted.
struct Periodic_insertion {
    enum class Outcome : std::uint8_t {
        done,
        taken,     ///< a vertex is there, or an image of one
        not_local  ///< the cells that change are not all different: to be built
    };
    Outcome outcome;
    Index vertex = none;  ///< where the place is taken
};

/*
      +-----------+-----------+     The cells whose sphere holds an image of the point are its cavity. Where no cell of
      |   ___     |   ___     |     the box is in it with two images, cavities of different images have no common inner
      |  /   \    |  /   \    |     point, so all images are inserted at once. Two cavities may touch; then the facets
      |  \___/    |  \___/    |     between new cells of different images are to be tested.
      +-----------+-----------+
*/
/// Inserts points into a periodic Delaunay triangulation and removes them, by replacing cells near them (docs/theory.md
/// 8.8). What is not possible in this way is left to the caller, which builds: where a cavity, or the star of a vertex,
/// meets an image of itself, as with few points, or in a box that is thinner than cells are long.
///
/// The result is proved as a build is: new cells are positive, the facets of new cells are Delaunay, exactly, and the
/// border is as before; the others have not changed.
template <int d>
class Periodic_inserter {
  public:
    /// v is no vertex of the table; its place is that of the new point. Without `done` the table is as it was. Expected
    /// O(n^(1/3) + degree) for points that are spread evenly. Precondition: there are cells. Throws bad_alloc, with the
    /// table as it was.
    [[nodiscard]] Periodic_insertion insert(const Periodic_scene<d>& scene, Index v);
    /// False where it is not possible in this way; then the table is as it was. Costs and throws as insert does.
    [[nodiscard]] bool remove(const Periodic_scene<d>& scene, Index v);

  private:
    using Scene = Periodic_scene<d>;

    [[nodiscard]] bool find_cavity(const Scene& scene, Lifted_cell<d> first, Index v);
    [[nodiscard]] bool find_star(const Scene& scene, Lifted_cell<d> first, Index v);
    [[nodiscard]] bool triangulate_link(const Scene& scene, Index v);
    /// Replaces gone_ by came_, if these are right.
    [[nodiscard]] bool settle(const Scene& scene);
    void keep_what_changes(const Scene& scene) const;
    [[nodiscard]] bool are_right(const Scene& scene);
    /// Adds a cell; false where it is there, elsewhere.
    [[nodiscard]] bool enter(Lifted_cell<d> c);
    [[nodiscard]] bool is_entered(Lifted_cell<d> c) const {
        return mark_[c.cell] != 0 && gone_[mark_[c.cell] - 1] == c;
    }
    void begin(const Scene& scene);

    Periodic_region<d> region_;
    Builder<d> builder_;
    std::vector<Lifted_cell<d>> gone_;
    std::vector<Cell_images<d>> came_;
    std::vector<std::uint32_t> mark_;        // by cell: its place in gone_, counted from 1, or 0
    std::vector<Image<d>> link_;             // the neighbours of a vertex
    std::vector<Corner_index> cospherical_;  // half-facets of new cells
    std::vector<Coordinates<d>> link_places_;
};

extern template class Periodic_inserter<2>;
extern template class Periodic_inserter<3>;

}  // namespace annulus::inline v1
