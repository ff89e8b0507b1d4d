// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/motion/curve_motion.h>
#include <annulus/motion/domain_3.h>
#include <annulus/motion/kept_cells_3.h>
#include <annulus/motion/sizing_3.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace annulus {

/// What one step of natural ODT asks for. Displacements in the caller's unit of length, over all vertices of cells of
/// the domain.
struct Nodt_step {
    double mean_displacement = 0;
    double max_displacement = 0;
    std::size_t vertices = 0;  ///< of cells of the domain; the others rest
    std::size_t boundary = 0;  ///< of these, on the surface
    std::size_t locked = 0;    ///< of these, at rest because their cells are good
    /// Of these, at rest because they are corners, because there is no surface around them, because their target is
    /// outside of the domain, or because it is another's place.
    std::size_t kept = 0;
};

/// How far from a surface a point may be that is said to be on it: 1e-9 of the diagonal of the domain's box.
[[nodiscard]] double rounding_of(const Domain_3& domain);
/// A flag for every point that is on the surface of the domain, up to `rounding_of`.
[[nodiscard]] std::vector<char> vertices_on_surface(const Domain_3& domain, std::span<const Coordinates<3>> points);

/// What one step leaves for the next: sizes where vertices have not moved, what is near those on the surface. For
/// steps of one Nodt_3.
class Nodt_memory {
    friend class Nodt_3;
    std::vector<Coordinates<3>> position_;
    std::vector<double> mu_;  ///< the sizing there
    std::vector<Nearby_3> nearby_;
};

/// Natural optimal Delaunay triangulation (section 4.2 of the paper; Tournois, Wormser, Alliez, Desbrun 2009).
///
/// A cell is of the domain when its circumcentre is (`cells_inside`). A surface facet is a facet of exactly one cell of
/// the domain. Which vertices live on the surface is said once: an interior vertex stays one when cells around it leave
/// the domain for a while, else the surface would swallow more and more of them.
///
/// An interior vertex wants to go to the mean of the circumcentres of its cells of the domain, weighted with
/// volume / mu³; a target outside of the domain is refused, and the vertex rests in this step. A vertex of the
/// surface wants to go to the mean of the circumcentres of its surface facets, weighted with area / mu². It rests
/// unless these facets are a disc around it: where features are thinner than the mesh, sheets of facets touch, and
/// their mean is the place of none. Of the way to that mean it goes what is in its tangent plane, across the mean
/// normal of these facets weighted with area: the rest only leads into the domain, and from a tip down its sides. It
/// goes three quarters of that (`surface_relaxation`), by at most a tenth (`surface_stride`) of the distance to its
/// nearest neighbour on the surface, and from there to the nearest point of the surface. All vertices go at once, and
/// neighbours who go against each other all the way exchange their places for ever: on the regular triangular lattice
/// this mode is multiplied by -1 a step. (Rows that go against each other are a above and b below one of their
/// vertices. The triangles of its star above have areas a/2 and circumcentres at heights (a² + 1/4) / 2a,
/// (a² - 1/4) / 2a, (a² - 1/4) / 2a, so the mean of all six is at (a - b) / 2: where the row would be mirrored in the
/// middle.) On curved surfaces such modes may be multiplied by less than -1, and grow. Three quarters of the way damp
/// all that full steps multiply by more than -5/3. A tenth of an edge is what the mean changes by at once when a flat
/// cell at the surface enters or leaves the domain; vertices that follow such jumps never come to rest. mu is the
/// sizing (its mean over the corners of a cell or facet).
///
/// Sharp edges, where they are given: a vertex on one goes along it, as far as others on the surface
/// (`Curve_motion`); a corner rests.
///
/// Locks: given an angle, a vertex rests while every dihedral angle of its cells of the domain is between it and 180
/// degrees less it. This is judged in every step from the cells as they are, so a vertex is free again as soon as a
/// move nearby has spoilt one of them.
class Nodt_3 {
  public:
    static constexpr double surface_relaxation = 0.75;
    static constexpr double surface_stride = 0.1;

    /// `domain` must outlive this. `on_surface` has a flag for every vertex; `sharp` has sharp edges of the domain's
    /// surface, and vertices on these. `threads` >= 1, 0 < lock_degrees < 70.5 (the regular tetrahedron), else
    /// Error(usage).
    Nodt_3(const Domain_3& domain, Sizing_3 sizing, std::vector<char> on_surface,
           std::optional<double> lock_degrees = {}, int threads = 1, Curve_motion sharp = {});

    /// Sets target[v] for every vertex. Targets differ if positions do. `inside` has a flag for every cell.
    ///
    /// Preconditions: positions are finite and differ; cells are positive. The result is the same bit for bit
    /// whatever the number of threads. Expected O(n). Throws Error(wrong_size). `target` must not overlap `position`.
    Nodt_step step(const Cells_3& cells, std::span<const char> inside, std::span<const Coordinates<3>> position,
                   std::span<Coordinates<3>> target) const;
    /// The same of cells that were measured at `position` with the same domain, and with a memory: the result is that
    /// of a step with none, bit for bit.
    Nodt_step step(const Kept_cells_3& cells, std::span<const Coordinates<3>> position,
                   std::span<Coordinates<3>> target, Nodt_memory& memory) const;

  private:
    struct Mesh;
    struct Sums;
    Nodt_step step_of(const Mesh& mesh, std::span<const Coordinates<3>> position, std::span<Coordinates<3>> target,
                      Nodt_memory& memory) const;
    void size_up(std::span<const Coordinates<3>> position, Nodt_memory& memory) const;
    void sum_cells(const Mesh& mesh, std::span<const Coordinates<3>> position, std::span<const double> mu,
                   Sums& sums) const;
    [[nodiscard]] bool is_good(const std::array<Index, 4>& cell, std::span<const Coordinates<3>> position) const;

    const Domain_3& domain_;
    Sizing_3 sizing_;
    std::vector<char> on_surface_;
    std::optional<double> lock_cosine_;
    int threads_;
    Curve_motion sharp_;
};

}  // namespace annulus
