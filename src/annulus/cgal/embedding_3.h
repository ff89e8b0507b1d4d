// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/error.h>
#include <annulus/certificate/ladder.h>
#include <annulus/certificate/theta.h>
#include <annulus/mesh/certificates.h>
#include <annulus/cgal/insertion.h>
#include <annulus/cgal/table_3.h>
#include <annulus/cgal/types_3.h>
#include <annulus/engine/embedding.h>
#include <annulus/mesh/measures.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace annulus {

/// CGAL's 3D Delaunay triangulation with its flat mirror: the only code that changes both.
template <class Info>
class Cgal_embedding_3 final : public Embedding<3> {
  public:
    static constexpr int dimension_of_space = 3;
    using Triangulation = Delaunay_3<Info>;
    using Point = typename Triangulation::Point;
    using Vertex_handle = typename Triangulation::Vertex_handle;
    using Cell_handle = typename Triangulation::Cell_handle;

    [[nodiscard]] static Coordinates<3> coordinates(const Point& p) { return {p.x(), p.y(), p.z()}; }
    [[nodiscard]] static Point point(const Coordinates<3>& x) { return {x[0], x[1], x[2]}; }

    [[nodiscard]] const Triangulation& triangulation() const { return tr_; }
    [[nodiscard]] Triangulation& triangulation() { return tr_; }
    [[nodiscard]] Vertex_handle handle(Index v) const { return handle_[at(v)]; }
    [[nodiscard]] Index vertex_bound() const { return static_cast<Index>(handle_.size()); }
    /// CGAL's cell of a cell of the mirror.
    [[nodiscard]] Cell_handle cell(Index c) const { return cell_[at(c)]; }

    /// Builds from nothing; vertex i is x[i]. Throws Error(collision) naming the pair when two points are equal.
    void build(std::span<const Coordinates<3>> x);
    /// (Re)builds the flat mirror from CGAL's object. O(n).
    void mirror() override;
    void drop_mirror() noexcept override;
    [[nodiscard]] bool mirrored() const override { return mirrored_; }
    void list_cells(std::vector<Index>& vertices) const override {
        for_each_finite_cell([&](const auto& cell) { vertices.insert(vertices.end(), cell.begin(), cell.end()); });
    }
    [[nodiscard]] bool has(Index v) const override { return handle_[at(v)] != Vertex_handle(); }
    [[nodiscard]] Sample sample(std::span<const Coordinates<3>> x, std::size_t count) const override;

    [[nodiscard]] Cell_table<3>& table() override { return table_; }
    [[nodiscard]] const Cell_table<3>& table() const { return table_; }
    [[nodiscard]] std::size_t vertices() const override { return tr_.number_of_vertices(); }
    [[nodiscard]] int dimension() const override { return tr_.dimension(); }
    [[nodiscard]] bool delaunay_of(std::span<const Coordinates<3>> x, std::span<const Index> vertices,
                                   std::vector<Cell_points<3>>& cells) override;
    void follow(std::span<const Index> cells) override;
    void restore_cells(std::span<const Index> cells, std::vector<Index>& made) override;
    [[nodiscard]] bool reinsert(Index v, const Coordinates<3>& p, std::vector<Index>& changed) override;
    void set_point(Index v, const Coordinates<3>& p) override { handle_[at(v)]->set_point(point(p)); }
    void set_points(std::span<const Coordinates<3>> x) override;
    void rebuild(std::span<const Coordinates<3>> x) override;
    /// The same after a call that failed half way: x has a position for every index there is to be, `fresh` (or `none`) is one
    /// that the call inserted.
    void restore(std::span<const Coordinates<3>> x, Index fresh);
    /// No cells, until a rebuild.
    void clear_cells() noexcept;
    /// Seconds the last rebuild spent on keeping handles valid.
    [[nodiscard]] double handle_seconds() const { return handle_seconds_; }

    /// Inserts p as vertex v (a new index, or a vacant one). False, with nothing changed, when a vertex is there.
    [[nodiscard]] bool insert(Index v, const Coordinates<3>& p, std::vector<Index>& changed);
    /// Removes v; its index becomes vacant and its handle invalid.
    void remove(Index v, std::vector<Index>& changed);

    /// The paper's baseline: locate, insert, remove, with v's handle kept.
    [[nodiscard]] Relocation relocate(Index v, const Coordinates<3>& p);
    /// In place where no topological change is needed, else the same: paper 3.1 has no flips in space. Not CGAL's
    /// `move_if_no_collision`, whose insertion into a star it has just made crashes on degenerate input (5.5).
    [[nodiscard]] Relocation relocate_by_flips(Index v, const Coordinates<3>& p);
    /// Writes v's point when no topological change is needed. False, with nothing changed, when one is.
    [[nodiscard]] bool update_in_place(Index v, const Coordinates<3>& p);

    /// Least tolerance of the certificates of v at CGAL's points, certified. Precondition: dimension 3.
    [[nodiscard]] double star_tolerance(Index v) const;
    /// Least theta of the finite bi-cells that contain v, at CGAL's points; pi/2 when there is none.
    [[nodiscard]] double theta(Index v) const;
    /// Calls visit(vertices) for each finite cell; triangles or edges (padded with `none`) when all points are coplanar or
    /// collinear.
    template <class Visit>
    void for_each_finite_cell(Visit visit) const;

    /// Widths, tolerances and theta of everything, at CGAL's points. O(n).
    [[nodiscard]] Measures measure() const;

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    /// A triangulation whose cells can be numbered, for rebuilding.
    using Plain = Delaunay_3<No_info>;

    /// A facet seen from one of its cells.
    using Facet = std::pair<Cell_handle, int>;

    template <class T>
    [[nodiscard]] static Index index_of(const T& tr, typename T::Vertex_handle v) {
        return tr.is_infinite(v) ? infinite : v->index();
    }
    [[nodiscard]] Vertex_handle vertex_of(Index v) const {
        return v == infinite ? tr_.infinite_vertex() : handle_[at(v)];
    }
    [[nodiscard]] std::vector<Cell_handle> star(Vertex_handle v) const;
    void substitute(Vertex_handle old, Vertex_handle replacement);
    /// A cell of CGAL's with its corners in an order that depends on its vertices alone: which they are, and its orientation.
    struct Ordered_cell {
        std::array<Index, 4> vertices;
        Cell_handle cell;
        friend bool operator<(const Ordered_cell& l, const Ordered_cell& r) { return l.vertices < r.vertices; }
    };
    [[nodiscard]] Ordered_cell put_in_order(Cell_handle c);
    void put_in_order(std::vector<Cell_handle>& cells);
    void adopt(std::vector<Cell_handle> cells, std::vector<Index>& changed);
    [[nodiscard]] std::vector<Index> cells_replaced_by(const std::vector<Cell_handle>& cells);
    Index new_cell(Cell_handle c);
    [[nodiscard]] static int slot_of_facet(Cell_handle n, Cell_handle c, int i);
    void take_cells(Triangulation& other) noexcept;
    [[nodiscard]] bool detach(Index v, std::vector<Index>& changed);
    [[nodiscard]] bool attach(Index v, const Coordinates<3>& p, Vertex_handle near, std::vector<Index>& changed);
    [[nodiscard]] bool rest_is_flat(Vertex_handle v) const;
    [[nodiscard]] Verdict facet_verdict(const Facet& f) const;
    [[nodiscard]] Verdict cell_verdict(Cell_handle c) const;
    [[nodiscard]] std::array<Vertex_handle, 5> bicell(const Facet& f) const;
    template <class Visit>
    void for_each_facet_around(Vertex_handle v, Visit visit) const;
    [[nodiscard]] double facet_theta(const Facet& f) const;
    static void insert_all(Triangulation& tr, std::span<const Coordinates<3>> x, std::span<const Index> order,
                           std::vector<Vertex_handle>* handle);

    Triangulation tr_;
    Cell_table<3> table_;
    std::vector<Cell_handle> cell_;                  // by cell
    std::vector<Vertex_handle> handle_;              // by vertex; default for a vacant index
    Insertion_order<Triangulation, 3> order_;
    std::vector<char> mark_;                         // by cell, while cells are replaced
    bool mirrored_ = false;
    bool shuffled_ = false;  // CGAL's removal has had a say in the order of its cells
    double handle_seconds_ = 0.0;
};

}  // namespace annulus

#include <annulus/cgal/build_3.h>
#include <annulus/cgal/mirror_3.h>
#include <annulus/cgal/relocation_3.h>
#include <annulus/cgal/star_3.h>
