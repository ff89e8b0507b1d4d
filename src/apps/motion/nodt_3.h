// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/curve_motion.h>
#include <apps/motion/domain_3.h>
#include <apps/motion/kept_cells_3.h>
#include <apps/motion/sizing_3.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// Statistics of one step of natural ODT. Displacements in the caller's unit of length, over all vertices of cells of
/// the domain.
struct Nodt_step {
    double mean_displacement = 0;
    double max_displacement = 0;
    std::size_t vertices = 0;  ///< of cells of the domain; the others rest
    std::size_t boundary = 0;  ///< of these, on the surface
    std::size_t locked = 0;    ///< of these, at rest because their cells are good
    /// Of these, at rest because they are corners, because there is no surface around them, because their target is
    /// outside the domain, or because it is the position of another vertex.
    std::size_t kept = 0;
};

/// The distance up to which a point counts as on the surface: 1e-9 of the diagonal of the domain's box.
[[nodiscard]] double rounding_of(const Domain_3& domain);
/// A flag for every point that is on the surface of the domain, up to `rounding_of`.
[[nodiscard]] std::vector<char> vertices_on_surface(const Domain_3& domain, std::span<const Coordinates<3>> points);

/// State kept from one step for the next: sizes where vertices have not moved, and the surface near those on it. For
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
/// the domain. Which vertices are on the surface is fixed at the beginning: an interior vertex remains interior when
/// cells around it leave the domain for a while, else the surface would absorb more and more of them.
///
/// The target of an interior vertex is the mean of the circumcentres of its cells of the domain, weighted with volume /
/// mu³; a target outside the domain is refused, and the vertex rests in this step. The target of a surface vertex is
/// the mean of the circumcentres of its surface facets, weighted with area / mu². It rests unless these facets are a
/// disc around it: where features are thinner than the mesh, sheets of facets touch, and their mean is on none of them.
/// Only the component of the displacement in its tangent plane is used, perpendicular to the mean normal of these
/// facets weighted with area: the rest only leads into the domain, and from a tip down its sides. The vertex moves by
/// three quarters of that (`surface_relaxation`), by at most a tenth (`surface_stride`) of the distance to its nearest
/// neighbour on the surface, and from there to the nearest point of the surface. All vertices move at once, and
/// neighbours that move towards each other by full steps exchange their positions for ever: on the regular triangular
/// lattice this mode is multiplied by -1 in each step. (Rows that move towards each other are a above and b below one
/// of their vertices. The triangles of its star above have areas a/2 and circumcentres at heights (a² + 1/4) / 2a, (a²
/// - 1/4) / 2a, (a² - 1/4) / 2a, so the mean of all six is at (a - b) / 2: where the row would be mirrored in the
/// middle.) On curved surfaces such modes may be multiplied by less than -1, and grow. Three quarters of the way damp
/// all that full steps multiply by more than -5/3. The mean jumps by a tenth of an edge when a flat cell at the surface
/// enters or leaves the domain; vertices that follow such jumps never come to rest. mu is the sizing (its mean over the
/// corners of a cell or facet).
///
/// Sharp edges, where they are given: a vertex on one moves along it, as far as others on the surface (`Curve_motion`);
/// a corner rests.
///
/// Locks: given an angle, a vertex rests while every dihedral angle of its cells of the domain is between it and 180
/// degrees less it. This is tested in every step with the current cells, so that a vertex is unlocked as soon as a move
/// nearby has spoilt one of them.
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
    Nodt_step step(const Mesh_cells<3>& cells, std::span<const char> inside, std::span<const Coordinates<3>> position,
                   std::span<Coordinates<3>> target) const;
    /// The same for cells that were measured at `position` with the same domain, and with a memory: bit for bit the
    /// result of a step without one.
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

}  // namespace annulus::inline v1
