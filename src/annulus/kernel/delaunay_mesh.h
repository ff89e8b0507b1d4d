// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/cavity_retriangulator.h>
#include <annulus/kernel/flat_cells.h>
#include <annulus/kernel/kept_buffers.h>
#include <annulus/kernel/vertex_set.h>
#include <annulus/mesh/corner_table.h>
#include <annulus/mesh/landmarks.h>
#include <annulus/types.h>

#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A Delaunay triangulation: which indices are vertices, and the cells, which are stored only in a Corner_table. This
/// class builds it and inserts and removes vertices; the engine changes the table by flips.
///
/// Positions belong to the Update_strategy and are passed to each call: `positions` are those at which the
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

    /// Where insertions and moves begin the search for their position, and how far they have walked.
    [[nodiscard]] const Landmarks<d>& landmarks() const { return landmarks_; }

    /// A time step has ended: the buffers of rebuilds may be freed (Kept_buffers).
    void end_step() noexcept;
    /// Whether there are such buffers.
    [[nodiscard]] bool holds_buffers() const { return builder_.hold_memory(); }
    /// The largest number of threads for a build; the result does not depend on it.
    void set_threads(int threads) { threads_ = threads; }
    /// Builds from nothing; vertex i is x[i]. Throws Error(duplicate_point), naming the pair, when two points are
    /// equal, and Error(too_large). Expected O(n).
    void build(std::span<const Coordinates<d>> x) { build(x, {}); }
    /// The same but for these indices, each once, which are free.
    void build(std::span<const Coordinates<d>> x, std::span<const Index> free);
    /// Rebuilds everything at x. Throws the same errors, with nothing changed.
    void rebuild(std::span<const Coordinates<d>> x);
    /// The same after a call that failed half way: x has a position for every index that is to exist. `fresh` (or
    /// `none`) is a vertex that the call inserted.
    void restore(std::span<const Coordinates<d>> x, Index fresh);
    /// Removes all cells, until a rebuild.
    void clear_cells() noexcept;
    /// Rebuilds what is now at these indices, whose cells a call has changed. Afterwards all cells are Delaunay at
    /// `positions` again. Preconditions: all other cells are Delaunay at `positions`, and these were before the call.
    /// `made` receives the new cells. O(k log k) for k cells.
    void restore_cells(std::span<const Coordinates<d>> positions, std::span<const Cell_index> cells,
                       std::vector<Cell_index>& made);

    // Functions that receive `positions` to write in write positions[v] = p unless nothing has changed.
    /// Inserts p as vertex v (a new index, for which there is room, or a free one); `changed` receives the new cells.
    /// Expected O(degree of v) after locating; O(n) with a small constant where all vertices lie in a hyperplane.
    /// Returns false, with nothing changed, when a vertex is there.
    [[nodiscard]] bool insert(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p,
                              std::vector<Cell_index>& changed);
    /// Removes v; its index becomes free.
    void remove(std::span<const Coordinates<d>> positions, Index v, std::vector<Cell_index>& changed);
    /// Removes v and inserts it again at p; `changed` receives the new cells. Returns false, with nothing changed,
    /// when the remaining vertices would be flat. Throws Error(duplicate_point), with nothing changed, when another
    /// vertex is there.
    [[nodiscard]] bool reinsert(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p,
                                std::vector<Cell_index>& changed);

    /// Appends the vertices of every finite cell at `positions`; where the vertices are flat, those of the simplices
    /// of the largest dimension that exists (padded with `none`).
    void list_cells(std::span<const Coordinates<d>> positions, std::vector<Index>& vertices) const;
    /// The same with the infinite cells, if there are any of dimension d.
    void list_all_cells(std::span<const Coordinates<d>> positions, std::vector<Index>& vertices) const;
    /// The finite cells and their neighbours. O(n).
    [[nodiscard]] Mesh_cells<d> cells(std::span<const Coordinates<d>> positions) const;
    /// The triangulation of vertices that lie in a hyperplane. O(n log n). Precondition: dimension() < d.
    [[nodiscard]] Flat_cells flat_cells(std::span<const Coordinates<d>> positions) const {
        return annulus::flat_cells<d>(positions, vertices_.list());
    }
    /// Least tolerance of the certificates of v, a certified lower bound. Precondition: dimension d.
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
    /// The number of points above which a part is not rebuilt.
    [[nodiscard]] std::size_t everything() const { return vertices_.size() + 64; }
    void attach(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p, Cell_index place,
                std::vector<Cell_index>& changed);
    [[nodiscard]] bool detach(std::span<const Coordinates<d>> positions, Index v, std::vector<Cell_index>& changed);
    /// The cell where p is (walk_to). `own`, or none, is a vertex that may be near. Precondition: dimension d.
    [[nodiscard]] Cell_index locate(std::span<const Coordinates<d>> positions, const Coordinates<d>& p, Index own);
    [[nodiscard]] bool is_taken(std::span<const Coordinates<d>> positions, const Coordinates<d>& p, Index but);
    [[nodiscard]] bool is_at_corner(std::span<const Coordinates<d>> positions, const Coordinates<d>& p, Cell_index c,
                                    Index but) const;

    Corner_table<d> table_;
    Vertex_set vertices_;
    int dimension_ = -1;
    // Affinely independent vertices with the affine hull of all, where that is a hyperplane or less.
    std::vector<Index> basis_;
    int threads_ = 1;
    Kept_buffers<Builder<d>> builder_;
    Cavity_retriangulator<d> local_{table_};
    Landmarks<d> landmarks_;
};

extern template class Delaunay_mesh<2>;
extern template class Delaunay_mesh<3>;

}  // namespace annulus::inline v1
