// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/triangulation/cell_table.h>

#include <array>
#include <span>
#include <vector>

namespace annulus {

/// The triangulation the strategies work on: CGAL's object and its flat mirror, changed together.
///
/// This is the seam between the code that knows CGAL (compiled in few translation units, a template on the caller's
/// vertex info) and the code that does not. Vertices are named by index; `infinite` is the vertex at infinity. CGAL's
/// points are the positions at which the object was last Delaunay; they change only through this interface.
template <int d>
class Embedding_base {
  public:
    virtual ~Embedding_base() = default;

    /// The flat mirror; meaningful while `dimension() == d`.
    [[nodiscard]] virtual Cell_table<d>& table() = 0;
    /// Number of vertices in the triangulation, infinity not counted.
    [[nodiscard]] virtual std::size_t vertices() const = 0;
    /// Affine dimension of the vertices, -1 when there are none.
    [[nodiscard]] virtual int dimension() const = 0;

    /// Takes v out of the triangulation at the present points, keeping its handle; `changed` receives the cells that
    /// are new. False, with nothing changed, when the rest would be flat. Precondition: Delaunay at CGAL's points.
    [[nodiscard]] virtual bool detach(Index v, std::vector<Index>& changed) = 0;
    /// Puts a detached v back at position p. False, with nothing changed, when another vertex is there already.
    [[nodiscard]] virtual bool attach(Index v, const Coordinates<d>& p, std::vector<Index>& changed) = 0;

    /// Writes CGAL's point of v, or of every vertex in the triangulation; no combinatorial change.
    virtual void set_point(Index v, const Coordinates<d>& p) = 0;
    virtual void set_points(std::span<const Coordinates<d>> x) = 0;

    /// Builds everything anew at x with CGAL (spatial sort), keeping vertex handles. Throws Error(collision), with
    /// nothing changed, when two vertices share a position.
    virtual void rebuild(std::span<const Coordinates<d>> x) = 0;
};

/// What a move of one vertex by CGAL came to. `refused`: another vertex is there, and nothing has changed.
enum class Relocation { refused, kept, flipped, reinserted };

template <int d>
class Embedding;

template <>
class Embedding<2> : public Embedding_base<2> {
  public:
    /// Flips the facet opposite to corner h in both.
    virtual void flip(Index h) = 0;
};

template <>
class Embedding<3> : public Embedding_base<3> {
  public:
    /// Puts the cells `fresh`, each with its vertices in positive order, in the place of the cells `old`; `created` receives
    /// the new ones. Every flip of space is one call. Precondition: both fill the same polyhedron, and the result is simplicial.
    virtual void replace(std::span<const Index> old, std::span<const std::array<Index, 4>> fresh,
                         std::vector<Index>& created) = 0;
};

}  // namespace annulus
