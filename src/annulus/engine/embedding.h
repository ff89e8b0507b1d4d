// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/sample.h>
#include <annulus/mesh/cell_table.h>
#include <annulus/mesh/measures.h>
#include <annulus/mesh/mesh_cells.h>

#include <array>
#include <span>
#include <vector>

namespace annulus {

/// What a move of one vertex came to that the engine left to the embedding. `refused`: another vertex is there, and nothing has changed.
enum class Relocation { refused, kept, flipped, reinserted };

/// What the engine wants of whoever builds triangulations, inserts and removes: the seam between it and CGAL.
///
/// There is the triangulation itself, which others may hold handles of, and its flat mirror, which the engine changes. Vertices are
/// named by index; `infinite` is the vertex at infinity.
///
/// Positions are their owner's (Upkeep) and come with each call: `home` are those at which the triangulation is Delaunay. CGAL's vertices
/// have a point each, which an embedding keeps up because handles show it.
template <int d>
class Embedding {
  public:
    virtual ~Embedding() = default;
    /// For what is parallel; nothing depends on it.
    void set_threads(int threads) { threads_ = threads; }

    /// The flat mirror; meaningful while `dimension() == d`.
    [[nodiscard]] virtual Cell_table<d>& table() = 0;
    /// Number of vertices in the triangulation, infinity not counted.
    [[nodiscard]] virtual std::size_t vertices() const = 0;
    /// One more than the largest index in use.
    [[nodiscard]] virtual std::size_t vertex_bound() const = 0;
    /// Affine dimension of the vertices, -1 when there are none.
    [[nodiscard]] virtual int dimension() const = 0;
    /// Whether v is in the triangulation. Precondition: v is below the bound.
    [[nodiscard]] virtual bool has(Index v) const = 0;

    /// Builds from nothing; vertex i is x[i]. Throws Error(collision) naming the pair when two points are equal. O(n log n).
    virtual void build(std::span<const Coordinates<d>> x) = 0;
    /// Builds everything anew at x, keeping handles. Throws Error(collision), with nothing changed, when two vertices share a position.
    virtual void rebuild(std::span<const Coordinates<d>> x) = 0;
    /// The same after a call that failed half way: x has a position for every index there is to be, `fresh` (or `none`) is one
    /// that the call inserted.
    virtual void restore(std::span<const Coordinates<d>> x, Index fresh) = 0;
    /// No cells, until a rebuild.
    virtual void clear_cells() noexcept = 0;
    /// Seconds the last rebuild spent on keeping handles valid.
    [[nodiscard]] virtual double handle_seconds() const = 0;
    /// The cells of the Delaunay triangulation of some vertices at x, those with infinity too, each in positive order. False when they
    /// are flat, or two of them are at one place.
    [[nodiscard]] virtual bool delaunay_of(std::span<const Coordinates<d>> x, std::span<const Index> vertices,
                                           std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>>& cells) = 0;

    /// Mirrors the triangulation. O(n).
    virtual void mirror() = 0;
    /// After changes of the table that shall not be: brings it in line with the triangulation again, all of it, if there is a mirror.
    /// O(n log n).
    virtual void revert(std::span<const Coordinates<d>> home) = 0;
    /// Forgets the mirror. Strategies that do not use it work on the triangulation alone, which then costs less.
    virtual void drop_mirror() noexcept = 0;
    [[nodiscard]] virtual bool mirrored() const = 0;
    /// Whether the table is the triangulation and follows every change of it, be it mirrored for a strategy or not.
    [[nodiscard]] virtual bool tabulated() const { return mirrored(); }
    /// Brings the triangulation in line with the table, which differs only where it names cells: that are gone, new, or
    /// have other vertices or neighbours than they had.
    virtual void follow(std::span<const Cell_index> cells) = 0;
    /// The opposite: brings these cells of the table in line with the triangulation, under other numbers; `made` receives these.
    /// O(k log k) for k cells.
    virtual void restore_cells(std::span<const Coordinates<d>> home, std::span<const Cell_index> cells,
                               std::vector<Cell_index>& made) = 0;

    // Who is given `home` to write in writes home[v] = p, unless nothing has changed.
    /// Inserts p as vertex v (a new index, for which there is room, or a vacant one), in both; `changed` receives the cells that are new.
    /// False, with nothing changed, when a vertex is there.
    [[nodiscard]] virtual bool insert(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p,
                                      std::vector<Cell_index>& changed) = 0;
    /// Removes v; its index becomes vacant and its handle invalid.
    virtual void remove(std::span<const Coordinates<d>> home, Index v, std::vector<Cell_index>& changed) = 0;
    /// Takes v out and puts it back in at p, in both; `changed` receives the cells that are new. False, with nothing
    /// changed, when the rest would be flat. Throws Error(collision), with nothing changed but cells' numbers, when another vertex is there.
    /// Precondition: the mirror is its own.
    [[nodiscard]] virtual bool reinsert(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p,
                                        std::vector<Cell_index>& changed) = 0;

    // Moves of one vertex, from where it is not yet, without a mirror. The triangulation is Delaunay before and after.
    /// The paper's baseline: locate, insert, remove, with v's handle kept.
    [[nodiscard]] virtual Relocation relocate(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) = 0;
    /// Section 3.1 of the paper: flips when no incident cell inverts, else relocation. In space in place where no topological change is
    /// needed, else relocation: paper 3.1 has no flips there, and CGAL's `move_if_no_collision`, whose insertion into a star it has
    /// just made crashes on degenerate input (5.5), is none either.
    [[nodiscard]] virtual Relocation relocate_by_flips(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) = 0;

    /// The point that v, or every vertex in the triangulation, shows; no combinatorial change.
    virtual void show_point(Index v, const Coordinates<d>& p) = 0;
    virtual void show_points(std::span<const Coordinates<d>> x) = 0;

    /// Appends the vertices of every finite cell, or of what is the largest there is of lower dimension (padded with `none`).
    virtual void list_cells(std::vector<Index>& vertices) const = 0;
    /// The same, and those with infinity, where there are any of dimension d.
    virtual void list_all_cells(std::vector<Index>& vertices) const = 0;
    /// The finite cells and who is whose neighbour; vertices are below `bound`. O(n).
    [[nodiscard]] virtual Mesh_cells<d> cells(std::size_t bound) const = 0;
    /// Whether rebuild(x) would sort the vertices first, which is a good part of its price. O(1).
    [[nodiscard]] virtual bool rebuild_sorts(std::span<const Coordinates<d>> x) const = 0;
    /// Looks at a cell of some `count` vertices, at x. O(count).
    [[nodiscard]] virtual Sample sample(std::span<const Coordinates<d>> x, std::size_t count) const = 0;
    /// Least tolerance of the certificates of v, certified. Precondition: dimension d.
    [[nodiscard]] virtual double star_tolerance(std::span<const Coordinates<d>> home, Index v) const = 0;
    /// Least theta of the finite bi-cells that contain v; pi/2 when there is none.
    [[nodiscard]] virtual double theta(std::span<const Coordinates<d>> home, Index v) const = 0;
    /// Widths, tolerances and theta of everything. O(n).
    [[nodiscard]] virtual Measures measure(std::span<const Coordinates<d>> home) const = 0;

  protected:
    int threads_ = 1;
};

}  // namespace annulus
