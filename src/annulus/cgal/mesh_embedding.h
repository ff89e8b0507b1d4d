// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/embedding.h>
#include <annulus/engine/local_delaunay.h>
#include <annulus/mesh/landmarks.h>

#include <memory>
#include <vector>

namespace annulus {

/// A triangulation that is a Cell_table and nothing else. CGAL builds it, and small parts of it, and is gone again.
///
/// The table is the triangulation, so there is nothing that has to follow it; whether it is "mirrored" says only whether a strategy works on it.
/// What the engine has changed and wants back is built anew at the points (`restore_cells`).
template <int d>
class Mesh_embedding final : public Embedding<d> {
  public:
    Mesh_embedding();
    ~Mesh_embedding() override;

    [[nodiscard]] Cell_table<d>& table() override { return table_; }
    [[nodiscard]] const Cell_table<d>& table() const { return table_; }
    [[nodiscard]] std::size_t vertices() const override { return vertices_; }
    [[nodiscard]] std::size_t vertex_bound() const override { return present_.size(); }
    [[nodiscard]] int dimension() const override { return dimension_; }
    [[nodiscard]] bool has(Index v) const override { return present_[at(v)] != 0; }

    void build(std::span<const Coordinates<d>> x) override;
    void rebuild(std::span<const Coordinates<d>> x) override;
    void restore(std::span<const Coordinates<d>> x, Index fresh) override;
    void clear_cells() noexcept override;
    [[nodiscard]] double handle_seconds() const override { return 0.0; }
    [[nodiscard]] bool delaunay_of(std::span<const Coordinates<d>> x, std::span<const Index> vertices,
                                   std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>>& cells) override;

    void mirror() override { mirrored_ = true; }
    void revert(std::span<const Coordinates<d>> home) override { rebuild(home); }
    void drop_mirror() noexcept override { mirrored_ = false; }
    [[nodiscard]] bool mirrored() const override { return mirrored_; }
    [[nodiscard]] bool tabulated() const override { return true; }
    void follow(std::span<const Cell_index>) override {}
    void restore_cells(std::span<const Coordinates<d>> home, std::span<const Cell_index> cells, std::vector<Cell_index>& made) override;

    [[nodiscard]] bool insert(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p, std::vector<Cell_index>& changed) override;
    void remove(std::span<const Coordinates<d>> home, Index v, std::vector<Cell_index>& changed) override;
    [[nodiscard]] bool reinsert(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p, std::vector<Cell_index>& changed) override;
    [[nodiscard]] Relocation relocate(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) override;
    /// In place where no topological change is needed, else relocation, in the plane too.
    [[nodiscard]] Relocation relocate_by_flips(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) override;
    void show_point(Index, const Coordinates<d>&) override {}  // no handles
    void show_points(std::span<const Coordinates<d>>) override {}

    void list_cells(std::vector<Index>& vertices) const override;
    void list_all_cells(std::vector<Index>& vertices) const override;
    [[nodiscard]] Mesh_cells<d> cells(std::size_t bound) const override;
    [[nodiscard]] bool rebuild_sorts(std::span<const Coordinates<d>> x) const override;
    [[nodiscard]] Sample sample(std::span<const Coordinates<d>> x, std::size_t count) const override;
    [[nodiscard]] double star_tolerance(std::span<const Coordinates<d>> home, Index v) const override;
    [[nodiscard]] double theta(std::span<const Coordinates<d>> home, Index v) const override;
    [[nodiscard]] Measures measure(std::span<const Coordinates<d>> home) const override;

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    struct Builder;

    void replace_everything(std::span<const Coordinates<d>> x, std::vector<Cell_index>& made);
    void keep_present(std::vector<Cell_index>& cells, std::size_t first) const;
    void attach(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p, Cell_index place,
                std::vector<Cell_index>& changed);
    [[nodiscard]] bool detach(std::span<const Coordinates<d>> home, Index v, std::vector<Cell_index>& changed);
    /// Writes v's position when no topological change is needed. False, with nothing changed, when one is.
    [[nodiscard]] bool update_in_place(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p);
    /// Where p is (walk_to); own, or none, is a vertex that may be near. Precondition: dimension d.
    [[nodiscard]] Cell_index locate(std::span<const Coordinates<d>> home, const Coordinates<d>& p, Index own);
    [[nodiscard]] bool is_taken(std::span<const Coordinates<d>> home, const Coordinates<d>& p, Index but);
    [[nodiscard]] bool is_at_corner(std::span<const Coordinates<d>> home, const Coordinates<d>& p, Cell_index c,
                                    Index but) const;

    Cell_table<d> table_;
    std::vector<char> present_;          // by vertex; 0 for a vacant index
    std::size_t vertices_ = 0;
    int dimension_ = -1;
    std::vector<Index> flat_cells_;      // d + 1 a cell, padded; of points of lower dimension
    bool mirrored_ = false;
    std::unique_ptr<Builder> builder_;
    Local_delaunay<d> local_{*this};
    Landmarks<d> landmarks_;
};

extern template class Mesh_embedding<2>;
extern template class Mesh_embedding<3>;

}  // namespace annulus
