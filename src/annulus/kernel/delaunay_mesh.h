// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/cavity_retriangulator.h>
#include <annulus/kernel/flat_cells.h>
#include <annulus/kernel/vertex_set.h>
#include <annulus/mesh/corner_table.h>
#include <annulus/mesh/landmarks.h>
#include <annulus/mesh/measures.h>
#include <annulus/mesh/mesh_cells.h>

#include <memory>
#include <span>
#include <vector>

namespace annulus {

/// What a move of one vertex came to. `refused`: another vertex is there, and nothing has changed.
enum class Relocation { refused, kept, reinserted };

/// A Delaunay triangulation of vertices, which indices name: which vertices it has, and its cells, which are a
/// Corner_table and nothing else. It is built, inserted into and removed from here; the engine changes the table by
/// flips.
///
/// Positions are their owner's (Update_strategy) and come with each call: `positions` are those at which the
/// triangulation is Delaunay.
template <int d>
class Delaunay_mesh {
  public:
    Delaunay_mesh();
    ~Delaunay_mesh();
    Delaunay_mesh(const Delaunay_mesh&) = delete;
    Delaunay_mesh& operator=(const Delaunay_mesh&) = delete;

    /// Meaningful while `dimension() == d`; without cells otherwise.
    [[nodiscard]] Corner_table<d>& table() { return table_; }
    [[nodiscard]] const Corner_table<d>& table() const { return table_; }
    /// Number of vertices in the triangulation, infinity not counted.
    [[nodiscard]] std::size_t vertices() const { return vertices_.size(); }
    /// One more than the largest index in use.
    [[nodiscard]] std::size_t vertex_bound() const { return vertices_.bound(); }
    /// Affine dimension of the vertices, -1 when there are none.
    [[nodiscard]] int dimension() const { return dimension_; }
    /// Whether v is in the triangulation. Precondition: v is below the bound.
    [[nodiscard]] bool has(Index v) const { return vertices_.has(v); }

    /// Where insertions and moves begin to look for their place, and how far they have walked.
    [[nodiscard]] const Landmarks<d>& landmarks() const { return landmarks_; }

    /// By at most how many threads everything is built; the result does not depend on it.
    void set_threads(int threads) { threads_ = threads; }
    /// Builds from nothing; vertex i is x[i]. Throws Error(duplicate_point) naming the pair when two points are equal,
    /// Error(too_large). Expected O(n).
    void build(std::span<const Coordinates<d>> x);
    /// Rebuilds everything at x. Throws the same, with nothing changed.
    void rebuild(std::span<const Coordinates<d>> x);
    /// The same after a call that failed half way: x has a position for every index there is to be, `fresh` (or
    /// `none`) is one that the call inserted.
    void restore(std::span<const Coordinates<d>> x, Index fresh);
    /// No cells, until a rebuild.
    void clear_cells() noexcept;
    /// Rebuilds what took the place of these cells, which a call has changed and which are Delaunay at `positions`
    /// again afterwards, as all others are; `made` receives them. O(k log k) for k cells.
    void restore_cells(std::span<const Coordinates<d>> positions, std::span<const Cell_index> cells,
                       std::vector<Cell_index>& made);

    // Given `positions` to write in, it writes positions[v] = p unless nothing has changed.
    /// Inserts p as vertex v (a new index, for which there is room, or a free one); `changed` receives the new cells.
    /// Expected O(degree of v) after locating; O(n) with a small constant where all vertices lie in a hyperplane.
    /// False, with nothing changed, when a vertex is there.
    [[nodiscard]] bool insert(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p,
                              std::vector<Cell_index>& changed);
    /// Removes v, whose index becomes free.
    void remove(std::span<const Coordinates<d>> positions, Index v, std::vector<Cell_index>& changed);
    /// Takes v out and puts it back in at p; `changed` receives the new cells. False, with nothing changed, when the
    /// rest would be flat. Throws Error(duplicate_point), with nothing changed, when another vertex is there.
    [[nodiscard]] bool reinsert(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p,
                                std::vector<Cell_index>& changed);

    /// The paper's baseline: a move of one vertex by a removal and an insertion.
    [[nodiscard]] Relocation relocate(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p);
    /// The same where a topological change is needed, else nothing but the position is written (paper 3.1).
    [[nodiscard]] Relocation relocate_in_place(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p);

    /// Appends the vertices of every finite cell, at `positions`, or of what is the largest there is of lower dimension
    /// (padded with `none`).
    void list_cells(std::span<const Coordinates<d>> positions, std::vector<Index>& vertices) const;
    /// The same, and those with infinity, where there are any of dimension d.
    void list_all_cells(std::span<const Coordinates<d>> positions, std::vector<Index>& vertices) const;
    /// The finite cells and their neighbours; vertices are below `bound`. O(n).
    [[nodiscard]] Mesh_cells<d> cells(std::span<const Coordinates<d>> positions, std::size_t bound) const;
    /// What there is where the vertices lie in a hyperplane. O(n log n). Precondition: dimension() < d.
    [[nodiscard]] Flat_cells flat_cells(std::span<const Coordinates<d>> positions) const {
        return annulus::flat_cells<d>(positions, vertices_.list());
    }
    /// Least tolerance of the certificates of v, certified. Precondition: dimension d.
    [[nodiscard]] double star_tolerance(std::span<const Coordinates<d>> positions, Index v) const;
    /// Least theta of the finite bi-cells that contain v; pi/2 when there is none.
    [[nodiscard]] double theta(std::span<const Coordinates<d>> positions, Index v) const;
    /// Widths, tolerances and theta of everything. O(n).
    [[nodiscard]] Measures measure(std::span<const Coordinates<d>> positions) const;

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

    [[nodiscard]] bool spans_more(std::span<const Coordinates<d>> positions, const Coordinates<d>& p) const;
    void find_basis(std::span<const Coordinates<d>> x);
    void insert_flat(std::span<const Coordinates<d>> positions, Index v);
    void replace_everything(std::span<const Coordinates<d>> x, std::vector<Cell_index>& made);
    void keep_present(std::vector<Cell_index>& cells, std::size_t first) const;
    /// More than that is not rebuilt in part.
    [[nodiscard]] std::size_t everything() const { return vertices_.size() + 64; }
    void attach(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p, Cell_index place,
                std::vector<Cell_index>& changed);
    [[nodiscard]] bool detach(std::span<const Coordinates<d>> positions, Index v, std::vector<Cell_index>& changed);
    /// Where p is (walk_to); own, or none, is a vertex that may be near. Precondition: dimension d.
    [[nodiscard]] Cell_index locate(std::span<const Coordinates<d>> positions, const Coordinates<d>& p, Index own);
    [[nodiscard]] bool is_taken(std::span<const Coordinates<d>> positions, const Coordinates<d>& p, Index but);
    [[nodiscard]] bool is_at_corner(std::span<const Coordinates<d>> positions, const Coordinates<d>& p, Cell_index c,
                                    Index but) const;

    Corner_table<d> table_;
    Vertex_set vertices_;
    int dimension_ = -1;
    // Affinely independent vertices that span what all do, where that is a hyperplane or less.
    std::vector<Index> basis_;
    int threads_ = 1;
    std::unique_ptr<Builder<d>> builder_;
    Cavity_retriangulator<d> local_{table_};
    Landmarks<d> landmarks_;
};

extern template class Delaunay_mesh<2>;
extern template class Delaunay_mesh<3>;

}  // namespace annulus
