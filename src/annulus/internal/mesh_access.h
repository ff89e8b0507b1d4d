// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/dirty_cells.h>
#include <annulus/internal/flat_cells.h>
#include <annulus/internal/index.h>

#include <array>
#include <cstddef>
#include <span>

namespace annulus::inline v1 {

template <int d>
class Delaunay_mesh;
template <int d>
class Moving_mesh;

/// The cells of a mesh, to read: the arrays of a Corner_table (mesh/corner_table.h), with its names. Valid until the
/// mesh changes. All members are O(1).
template <int d>
class Table_cells {
  public:
    /// By corner, four places for each cell.
    Table_cells(std::span<const Index> vertex, std::span<const Corner_index> twin) : vertex_(vertex), twin_(twin) {}

    [[nodiscard]] Cell_index cell_bound() const { return cell_of(Corner_index(static_cast<Index>(twin_.size()))); }
    [[nodiscard]] bool is_cell(Cell_index c) const { return vertex(corner(c, 0)) != none; }
    [[nodiscard]] auto cells() const {
        return Index_range(cell_bound(), [*this](Cell_index c) { return is_cell(c); });
    }

    [[nodiscard]] static constexpr Cell_index cell_of(Corner_index h) { return Cell_index(h.value() >> 2); }
    [[nodiscard]] static constexpr int slot_of(Corner_index h) { return static_cast<int>(h.value() & 3); }
    [[nodiscard]] static constexpr Corner_index corner(Cell_index c, int i) { return Corner_index(4 * c.value() + i); }

    [[nodiscard]] Index vertex(Corner_index h) const { return vertex_[h.offset()]; }
    [[nodiscard]] Corner_index twin(Corner_index h) const { return twin_[h.offset()]; }
    [[nodiscard]] std::array<Index, static_cast<std::size_t>(d + 1)> vertices(Cell_index c) const {
        std::array<Index, static_cast<std::size_t>(d + 1)> v{};
        for (int i = 0; i <= d; ++i) v[static_cast<std::size_t>(i)] = vertex(corner(c, i));
        return v;
    }

  private:
    std::span<const Index> vertex_;
    std::span<const Corner_index> twin_;
};

/// What CGAL's view needs of a mesh. The view is compiled with the caller's Info; through this class it needs no header
/// of mesh, kernel or engine. A copy is another way to the same mesh.
template <int d>
class Mesh_access {
  public:
    /// The mesh must outlive what is called here.
    Mesh_access(Delaunay_mesh<d>& mesh) : mesh_(&mesh) {}
    /// A Moving_mesh that is moved takes its mesh along.
    Mesh_access(Moving_mesh<d>& mesh);

    /// As in Delaunay_mesh.
    [[nodiscard]] int dimension() const;
    [[nodiscard]] std::size_t vertices() const;
    [[nodiscard]] bool has(Index v) const;
    [[nodiscard]] Flat_cells flat_cells(std::span<const Coordinates<d>> positions) const;
    /// Meaningful while dimension() is d; none otherwise.
    [[nodiscard]] Table_cells<d> cells() const;
    /// The log that is notified, from now on, before a cell changes. There is one for each mesh (voronoi_volumes of a
    /// Moving_mesh sets another), and it must live as long as the mesh changes.
    void set_dirty_cells(Dirty_cells& log) noexcept;

  private:
    Delaunay_mesh<d>* mesh_;
};

extern template class Mesh_access<2>;
extern template class Mesh_access<3>;

}  // namespace annulus::inline v1
