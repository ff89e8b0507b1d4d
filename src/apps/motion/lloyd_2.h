// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/neighbours.h>
#include <annulus/types.h>
#include <apps/motion/cell_2.h>
#include <apps/motion/density_2.h>
#include <apps/motion/kept_border_2.h>
#include <apps/motion/region_2.h>
#include <apps/motion/stars_2.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Statistics of one Lloyd iteration. Displacements in the caller's unit of length, over the vertices that are present.
struct Lloyd_step {
    double mean_displacement = 0;
    double max_displacement = 0;
    std::size_t kept = 0;  ///< vertices whose cell has no mass in the domain: they stay where they are
};

/// State kept from one step for the next: the target of a vertex is the same as before if its star is the same and
/// neither it nor a neighbour has moved. For steps of one Lloyd_2 over one Stars_2.
class Lloyd_memory {
    friend class Lloyd_2;
    std::vector<Coordinates<2>> position_, target_;
    std::vector<double> way_;     ///< how far it was to the target; negative where there was none
    std::vector<char> moved_;     ///< since the step before
    std::uint64_t readings_ = 0;  ///< of the stars, up to that step
};

/// Lloyd's iteration in 2D (section 4.1 of the paper): the target of every site is the centroid of its Voronoi cell,
/// cut to a domain, under a density. In a domain that is not convex, where that is outside of the domain, it is the
/// nearest point of the cut cell (`nearest_inside`): of all positions there, the sum of squared distances is least at
/// that one. Immutable; `step` may be called from several threads at once.
class Lloyd_2 {
  public:
    /// Throws what `require_density` does. `threads` >= 1, else Error(usage): the number that work on a step, or fewer
    /// where the machine has fewer. The targets of the vertices of `border`, which is that of the domain, are on their
    /// edges (`Kept_border_2::along`).
    Lloyd_2(Region_2 domain, Density_2 density, int threads = 1, Kept_border_2 border = {});

    /// Sets target[v] to the centroid of (Voronoi cell of v, cut to the domain) for every v. The vertices with an empty
    /// list in `neighbours`, unless v is the only one, are free: they keep their position and are not counted.
    ///
    /// Preconditions: `neighbours` are those of a Delaunay triangulation of `position`; positions are finite and
    /// differ; they may be outside of the domain. A list that is not that of a Delaunay triangulation still gives a
    /// target in the domain, or none. A target is in the domain up to its `tolerance()`, and in the cell up to a
    /// rounding of the coordinates. Cells being disjoint, targets of different vertices differ, as long as cells are
    /// larger than a rounding. Error of a target: that of `moments`, `Voronoi_cell_2` and `Region_cell_2`, and its
    /// rounding to double.
    ///
    /// The result is the same bit for bit whatever the number of threads. Expected O(n); no allocation per vertex.
    /// Throws Error(wrong_size) unless the three have the same size. `target` must not overlap `position`.
    Lloyd_step step(const Neighbours_2& neighbours, std::span<const Coordinates<2>> position,
                    std::span<Coordinates<2>> target) const;
    /// The same over stars, and with a memory: bit for bit the result of a step without one.
    Lloyd_step step(const Stars_2& stars, std::span<const Coordinates<2>> position, std::span<Coordinates<2>> target,
                    Lloyd_memory& memory) const;

    [[nodiscard]] const Region_2& domain() const { return domain_; }
    [[nodiscard]] const Density_2& density() const { return density_; }
    [[nodiscard]] int threads() const { return threads_; }

  private:
    [[nodiscard]] bool find_moved(const Stars_2& stars, std::span<const Coordinates<2>> position,
                                  Lloyd_memory& memory) const;
    template <class Lists, class Remembered>
    Lloyd_step step_over(const Lists& lists, std::span<const Coordinates<2>> position, std::span<Coordinates<2>> target,
                         std::vector<double>& way, Remembered remembered) const;

    Region_2 domain_;
    Density_2 density_;
    int threads_;
    Kept_border_2 border_;
};

/// The centroid of a cell under a density, as an offset from the cell's origin; false when the cell has no mass. A
/// centroid that is out of the cell by more than rounding (a cell thinner than that) becomes the mean of the corners.
[[nodiscard]] bool centroid(const Density_2& density, const Cell_2& cell, Coordinates<2>& offset);

}  // namespace annulus::inline v1
