// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// CGAL's predicates are compiled here, with the caller's flags.
#include <annulus/audit.h>
#include <annulus/internal/compiler_flags.h>
#include <annulus/internal/mesh_access.h>
#include <annulus/internal/vertex_numbers.h>

#include <array>
#include <atomic>
#include <mutex>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// A mesh as a CGAL triangulation: a copy, brought up to date on request. Traits is Cgal_traits of that triangulation's
/// type.
///
/// Vertices are created and removed with those of the mesh, so handles and info live as long as these. Cells and
/// points follow in update(), by a log of what has changed (Dirty_cells). Cells are overwritten in place, which costs
/// a tenth of creating them. A cell base of the caller's is reset first, so that data of a cell that went do not stay.
template <class Traits>
class Cgal_view {
  public:
    static constexpr int d = Traits::dimension;
    static constexpr int dimension_of_space = d;
    using Triangulation = typename Traits::Triangulation;
    using Point = typename Traits::Point;
    using Vertex = typename Traits::Vertex;
    using Cell = typename Traits::Cell;
    using Vertex_handle = typename Traits::Vertex_handle;
    using Cell_handle = typename Traits::Cell_handle;

    [[nodiscard]] static Coordinates<d> coordinates(const Point& p) { return Traits::coordinates(p); }
    [[nodiscard]] static Point point(const Coordinates<d>& x) { return Traits::point(x); }

    /// Copies a mesh that is built, at positions x. The mesh must not change any more once the view is gone. O(n).
    Cgal_view(Mesh_access<d> mesh, std::span<const Coordinates<d>> x);
    /// The same, with the data of other vertices: vertex v begins as a copy of *original(v).
    template <class Original>
    Cgal_view(Mesh_access<d> mesh, std::span<const Coordinates<d>> x, Original original);
    Cgal_view(const Cgal_view&) = delete;
    Cgal_view& operator=(const Cgal_view&) = delete;

    /// Brings the copy up to date with the mesh, whose positions are x: O(k) for k cells that have changed and
    /// vertices that have moved. May be called by several threads at once, while the mesh does not change. When it
    /// throws (bad_alloc), the next call starts again.
    const Triangulation& update(std::span<const Coordinates<d>> x) const;
    /// To be called before cells change; the others before vertex v, or every vertex, moves.
    void invalidate_cells() noexcept { state_.current = false; }
    void invalidate(Index v) noexcept;
    void invalidate() noexcept {
        state_.moved.all = true;
        state_.current = false;
    }

    /// Null for a free index.
    [[nodiscard]] Vertex_handle handle(Index v) const { return handle_[at(v)]; }
    /// A number below 0 for a vertex that is none of ours. Precondition: not null.
    [[nodiscard]] Index index(Vertex_handle v) const {
        const Index i = numbers_.of(v);
        return i >= 0 && at(i) < handle_.size() && handle_[at(i)] == v ? i : none;
    }
    /// Creates a vertex for adopt() to take or drop_reserved() to remove. Throws bad_alloc, with nothing changed.
    void reserve_vertex();
    void drop_reserved() noexcept;
    /// v is in the mesh now, at p. Precondition: reserve_vertex() was called.
    Vertex_handle adopt(Index v, const Coordinates<d>& p) noexcept;
    /// v is not in the mesh any more. Its handle becomes invalid.
    void forget(Index v) noexcept;

    /// Adds to `result` what is wrong with CGAL's object itself: points of vertices that are not at x, cells that do
    /// not fit together or are not those of the mesh. False when a vertex of a cell has no index, so that there are
    /// no cells to audit. O(n). Precondition: update(x).
    bool audit(std::span<const Coordinates<d>> x, Audit_result& result) const;

  private:
    using Points = std::array<Index, static_cast<std::size_t>(d + 1)>;
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] Vertex_handle vertex_of(Index v) const {
        return v == infinite ? tr_.infinite_vertex() : handle_[at(v)];
    }
    [[nodiscard]] Points points_of(Cell_handle c) const;

    // update.h
    template <class Create>
    void create_vertices(Create create);
    void update_cells(std::span<const Coordinates<d>> x) const;
    void update_points(std::span<const Coordinates<d>> x) const;
    void write_cells(std::span<const Cell_index> cells) const;
    void write_cell(const Table_cells<d>& t, Cell_index c) const;
    void write_all_cells() const;
    void write_flat_cells(std::span<const Coordinates<d>> x) const;
    void write_vertices() const;
    void remove_cells() const noexcept;

    // view_audit.h
    bool audit_vertices(std::span<const Coordinates<d>> x, Audit_result& result) const;
    void audit_adjacency(Audit_result& result) const;

    struct Moved {
        std::vector<Index> vertices;
        bool all = true;
    };
    struct State {
        std::atomic<bool> current = false;
        std::mutex updating;
        Moved moved;
    };

    Mesh_access<d> mesh_;
    mutable Triangulation tr_;
    std::vector<Vertex_handle> handle_;  // by vertex; default for a free index
    Vertex_numbers<Vertex, Vertex_handle> numbers_;
    Vertex_handle spare_;                // made by reserve_vertex()
    mutable By_cell<Cell_handle> cell_;  // by cell of the mesh
    mutable Dirty_cells dirty_cells_;
    mutable State state_;
};

}  // namespace annulus::inline v1

#include <annulus/internal/update.h>
#include <annulus/internal/view_audit.h>
