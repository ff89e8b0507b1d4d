// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/mesh/cell_table.h>
#include <annulus/engine/sample.h>

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
class Embedding {
  public:
    virtual ~Embedding() = default;

    /// The flat mirror; meaningful while `dimension() == d`.
    [[nodiscard]] virtual Cell_table<d>& table() = 0;
    /// Number of vertices in the triangulation, infinity not counted.
    [[nodiscard]] virtual std::size_t vertices() const = 0;
    /// Affine dimension of the vertices, -1 when there are none.
    [[nodiscard]] virtual int dimension() const = 0;

    /// The cells of the Delaunay triangulation of some vertices at x, those with infinity too, each in positive order. False when they
    /// are flat, or two of them are at one place.
    [[nodiscard]] virtual bool delaunay_of(std::span<const Coordinates<d>> x, std::span<const Index> vertices,
                                           std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>>& cells) = 0;
    /// Brings CGAL's cells in line with those of the table, which differ only where it names them: cells that are gone, new, or
    /// have other vertices or neighbours than they had.
    virtual void follow(std::span<const Index> cells) = 0;
    /// The opposite: brings these cells of the table in line with CGAL's, under other numbers; `made` receives these. O(k log k) for k cells.
    virtual void restore_cells(std::span<const Index> cells, std::vector<Index>& made) = 0;
    /// Takes v out and puts it back in at p, as CGAL does that, in both; `changed` receives the cells that are new. False, with nothing
    /// changed, when the rest would be flat. Throws Error(collision), with nothing changed but cells' numbers, when another vertex is there.
    /// Precondition: CGAL's object is Delaunay at its points, and the mirror is its own.
    [[nodiscard]] virtual bool reinsert(Index v, const Coordinates<d>& p, std::vector<Index>& changed) = 0;
    /// Mirrors CGAL's object anew: at first, or after changes of the table that shall not be. O(n log n).
    virtual void mirror() = 0;
    /// Forgets the mirror. Strategies that do not use it work on CGAL's object alone, which then costs less.
    virtual void drop_mirror() noexcept = 0;
    [[nodiscard]] virtual bool mirrored() const = 0;

    /// Appends the vertices of every finite cell, or of what is the largest there is of lower dimension.
    virtual void list_cells(std::vector<Index>& vertices) const = 0;
    /// Whether v is in the triangulation.
    [[nodiscard]] virtual bool has(Index v) const = 0;
    /// Looks at a cell of some `count` vertices, at x. O(count).
    [[nodiscard]] virtual Sample sample(std::span<const Coordinates<d>> x, std::size_t count) const = 0;

    /// Writes CGAL's point of v, or of every vertex in the triangulation; no combinatorial change.
    virtual void set_point(Index v, const Coordinates<d>& p) = 0;
    virtual void set_points(std::span<const Coordinates<d>> x) = 0;

    /// Builds everything anew at x with CGAL (spatial sort), keeping vertex handles. Throws Error(collision), with
    /// nothing changed, when two vertices share a position.
    virtual void rebuild(std::span<const Coordinates<d>> x) = 0;
};

/// What a move of one vertex by CGAL came to. `refused`: another vertex is there, and nothing has changed.
enum class Relocation { refused, kept, flipped, reinserted };

}  // namespace annulus
