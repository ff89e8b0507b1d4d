// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/environment.h>  // refuses -ffast-math: CGAL's predicates are compiled here, with the caller's flags
#include <annulus/arithmetic/error.h>
#include <annulus/cgal/insertion_order.h>
#include <annulus/cgal/neighbours_2.h>
#include <annulus/engine/embedding.h>
#include <annulus/mesh/audit.h>
#include <annulus/mesh/evaluate.h>
#include <annulus/mesh/landmarks.h>
#include <annulus/mesh/measures.h>
#include <annulus/mesh/replace_cells.h>
#include <annulus/mesh/walk.h>

#include <type_traits>
#include <utility>
#include <vector>

namespace annulus {

/// CGAL's Delaunay triangulation with its flat mirror: the only code that changes both.
///
/// Traits is Cgal_traits_2<Info> or Cgal_traits_3<Info>. A cell of CGAL's knows the number of its cell of the mirror;
/// `no_cell` means that it is not mirrored yet.
template <class Traits>
class Cgal_embedding final : public Embedding<Traits::dimension> {
  public:
    static constexpr int d = Traits::dimension;
    static constexpr int dimension_of_space = d;
    using Triangulation = typename Traits::Triangulation;
    using Point = typename Traits::Point;
    using Vertex_handle = typename Traits::Vertex_handle;
    using Cell_handle = typename Traits::Cell_handle;
    using Points = Cell_points<d>;
    /// What neighbours() fills; incomplete in space. Not a constraint on neighbours(): g++ 13 and older leave constraints out of the
    /// names of functions and newer compilers put them in, and a program of one could not be linked with a library of the other.
    struct No_neighbour_lists;
    using Neighbour_lists = std::conditional_t<d == 2, Neighbours_2, No_neighbour_lists>;

    [[nodiscard]] static Coordinates<d> coordinates(const Point& p) { return Traits::coordinates(p); }
    [[nodiscard]] static Point point(const Coordinates<d>& x) { return Traits::point(x); }

    [[nodiscard]] const Triangulation& triangulation() const { return tr_; }
    [[nodiscard]] Triangulation& triangulation() { return tr_; }
    [[nodiscard]] Vertex_handle handle(Index v) const { return handle_[at(v)]; }
    /// CGAL's cell of a cell of the mirror.
    [[nodiscard]] Cell_handle cell(Cell_index c) const { return cell_[c]; }

    [[nodiscard]] Cell_table<d>& table() override { return table_; }
    [[nodiscard]] const Cell_table<d>& table() const { return table_; }
    [[nodiscard]] std::size_t vertices() const override { return tr_.number_of_vertices(); }
    [[nodiscard]] std::size_t vertex_bound() const override { return handle_.size(); }
    [[nodiscard]] int dimension() const override { return tr_.dimension(); }
    [[nodiscard]] bool has(Index v) const override { return handle_[at(v)] != Vertex_handle(); }

    // build.h
    void build(std::span<const Coordinates<d>> x) override;
    void rebuild(std::span<const Coordinates<d>> x) override;
    void restore(std::span<const Coordinates<d>> x, Index fresh) override;
    void clear_cells() noexcept override;
    [[nodiscard]] double handle_seconds() const override { return handle_seconds_; }
    [[nodiscard]] bool delaunay_of(std::span<const Coordinates<d>> x, std::span<const Index> vertices,
                                   std::vector<Points>& cells) override;

    // mirror.h
    void mirror() override;
    void revert(std::span<const Coordinates<d>>) override {
        if (mirrored_) mirror();
    }
    void drop_mirror() noexcept override;
    [[nodiscard]] bool mirrored() const override { return mirrored_; }
    void follow(std::span<const Cell_index> cells) override;
    void restore_cells(std::span<const Coordinates<d>> home, std::span<const Cell_index> cells, std::vector<Cell_index>& made) override;

    // relocation.h
    [[nodiscard]] bool insert(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p, std::vector<Cell_index>& changed) override;
    void remove(std::span<const Coordinates<d>> home, Index v, std::vector<Cell_index>& changed) override;
    [[nodiscard]] bool reinsert(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p, std::vector<Cell_index>& changed) override;
    [[nodiscard]] Relocation relocate(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) override;
    [[nodiscard]] Relocation relocate_by_flips(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) override;
    void show_point(Index v, const Coordinates<d>& p) override { handle_[at(v)]->set_point(point(p)); }
    void show_points(std::span<const Coordinates<d>> x) override;

    // readings.h
    void list_cells(std::vector<Index>& vertices) const override {
        for_each_finite_cell([&](const auto& cell) { vertices.insert(vertices.end(), cell.begin(), cell.end()); });
    }
    void list_all_cells(std::vector<Index>& vertices) const override;
    [[nodiscard]] Mesh_cells<d> cells(std::size_t bound) const override;
    [[nodiscard]] bool rebuild_sorts(std::span<const Coordinates<d>> x) const override { return order_.sorts(x); }
    [[nodiscard]] Sample sample(std::span<const Coordinates<d>> x, std::size_t count) const override;
    [[nodiscard]] double star_tolerance(std::span<const Coordinates<d>> home, Index v) const override;
    [[nodiscard]] double theta(std::span<const Coordinates<d>> home, Index v) const override;
    [[nodiscard]] Measures measure(std::span<const Coordinates<d>> home) const override;
    /// Calls visit(vertices) for each finite cell, or of what is the largest there is when all points are in a plane or on a line
    /// (padded with `none`).
    template <class Visit>
    void for_each_finite_cell(Visit visit) const;
    /// Adds to a verdict what is wrong with CGAL's object itself: points of vertices that are not at x, cells that do
    /// not fit together or are not those of the mirror. False when not every vertex of a cell has an index, so that
    /// there are no cells to judge. O(n).
    bool audit_object(std::span<const Coordinates<d>> x, Audit_result& result) const;
    /// Neighbour lists of every vertex, in the plane. O(n).
    void neighbours(Neighbour_lists& out) const;

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

    template <class T>
    [[nodiscard]] static Index index_of(const T& tr, typename T::Vertex_handle v) {
        return tr.is_infinite(v) ? infinite : v->index();
    }
    template <class T, class Cell>
    [[nodiscard]] static Points points_of(const T& tr, Cell c) {
        Points x{};
        for (int i = 0; i <= d; ++i) x[static_cast<std::size_t>(i)] = index_of(tr, c->vertex(i));
        return x;
    }
    /// The cell of the mirror that a cell of CGAL's is, or `no_cell`.
    [[nodiscard]] static Cell_index number_of(Cell_handle c) { return Cell_index(c->cell()); }
    static void set_number(Cell_handle c, Cell_index number) { c->set_cell(number.value()); }
    [[nodiscard]] Vertex_handle vertex_of(Index v) const {
        return v == infinite ? tr_.infinite_vertex() : handle_[at(v)];
    }
    [[nodiscard]] Vertex_handle vertex_beyond(Cell_handle c, int i) const {
        return c->neighbor(i)->vertex(Traits::slot_beyond(tr_.tds(), c, i));
    }
    static void insert_all(Triangulation& tr, std::span<const Coordinates<d>> x, std::span<const Index> order,
                           std::vector<Vertex_handle>* handle);
    void take_cells(Triangulation& other) noexcept;

    bool audit_vertices(std::span<const Coordinates<d>> x, Audit_result& result) const;
    void audit_adjacency(Audit_result& result) const;
    void put_in_order(std::vector<Cell_handle>& cells) const;
    void adopt(std::vector<Cell_handle> cells, std::vector<Cell_index> old, std::vector<Cell_index>& changed);
    void join_replaced(const std::vector<Cell_handle>& cells, std::vector<Cell_index>& old);

    [[nodiscard]] std::vector<Cell_handle> star(Vertex_handle v) const;
    void substitute(Vertex_handle old, Vertex_handle replacement);
    [[nodiscard]] std::vector<Cell_handle> take_out(Vertex_handle v);
    [[nodiscard]] bool detach(Index v, std::vector<Cell_index>& changed);
    [[nodiscard]] bool attach(std::span<const Coordinates<d>> home, Index v, const Coordinates<d>& p, Index near,
                              std::vector<Cell_index>& changed);
    class Walker;
    [[nodiscard]] typename Traits::Place locate(std::span<const Coordinates<d>> home, const Coordinates<d>& p,
                                                Index own);
    void exchange(Vertex_handle v, Vertex_handle inserted, const Coordinates<d>& p);
    /// Writes v's point when no topological change is needed. False, with nothing changed, when one is.
    [[nodiscard]] bool update_in_place(Index v, const Coordinates<d>& p);
    [[nodiscard]] Relocation relocate_flat(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p);

    /// The certificate of facet (c, i), and where its points are.
    struct Certificate {
        Facet_kind kind{};
        Facet_points<d> point{};
        std::array<Coordinates<d>, static_cast<std::size_t>(d + 2)> x{};
    };
    [[nodiscard]] Certificate certificate(Cell_handle c, int i) const;
    [[nodiscard]] Verdict verdict_of_cell(Cell_handle c) const;
    template <class Visit>
    void for_each_facet_around(Vertex_handle v, Visit visit) const;

    Triangulation tr_;
    Cell_table<d> table_;
    By_cell<Cell_handle> cell_;
    std::vector<Vertex_handle> handle_;  // by vertex; default for a vacant index
    Insertion_order<d> order_;
    Landmarks<d> landmarks_;
    bool mirrored_ = false;
    bool shuffled_ = false;  // CGAL's removal has had a say in the order of its cells
    double handle_seconds_ = 0.0;
};

}  // namespace annulus

#include <annulus/cgal/build.h>
#include <annulus/cgal/mirror.h>
#include <annulus/cgal/object_audit.h>
#include <annulus/cgal/readings.h>
#include <annulus/cgal/relocation.h>
