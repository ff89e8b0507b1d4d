// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/audit.h>
#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/mesh/change_log.h>
#include <annulus/options.h>
#include <annulus/types.h>

#include <memory>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

template <int d>
class Update_strategy;

/// Vertices that move, the strategy that moves them, and their triangulation. Moving_delaunay and Moving_mesh
/// document what this class implements. Vertices are named by index.
template <int d>
class Engine {
  public:
    using Point = Coordinates<d>;

    /// The mesh must outlive the engine; nothing else may change it. Throws environment, usage (threads below 1).
    Engine(Delaunay_mesh<d>& mesh, const Options& options, std::unique_ptr<Update_strategy<d>> strategy);
    ~Engine();

    /// Triangulates these points. Called once.
    void build(std::span<const Point> points);
    /// In place of build(): takes the vertices of another engine, with their indices and its free ones.
    void build_copy(const Engine& other);

    Move_result move(Index i, const Point& p);
    Move_result move(std::span<const Index> indices, std::span<const Point> points);
    Move_result move_all(std::span<const Point> points);
    /// Returns the index of the new vertex.
    Index insert(const Point& p, Move_result& report);
    void remove(Index i, Move_result& report);
    Move_result recompute_tolerances();

    [[nodiscard]] std::size_t index_bound() const { return positions().size(); }
    [[nodiscard]] bool is_vertex(Index i) const;
    /// Throws unknown_vertex.
    void require_vertex(Index i) const;
    [[nodiscard]] std::span<const Index> vertex_of_input() const { return vertex_of_input_; }
    [[nodiscard]] std::span<const Point> positions() const;
    /// The positions at which the triangulation is Delaunay. They differ from positions() only while tolerances that
    /// are not certified are kept.
    [[nodiscard]] std::span<const Point> delaunay_positions() const;
    [[nodiscard]] Point fixed_position(Index i) const;
    [[nodiscard]] double tolerance(Index i) const;
    [[nodiscard]] double displacement(Index i) const;
    /// Every finite cell. O(n).
    [[nodiscard]] Mesh_cells<d> cells() const;
    [[nodiscard]] Audit_input<d> audit_input() const;
    [[nodiscard]] const Options& options() const { return options_; }
    [[nodiscard]] Strategy strategy() const;

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    template <class Call>
    void guarded(Call call, Index fresh = none);
    /// The same for moves, with the targets by index: all of them, or only those of the movers. A duplicate point is
    /// thrown with the names of both vertices.
    template <class Call>
    void guarded_moves(std::span<const Index> movers, std::span<const Point> targets, Call call);
    void recover(std::size_t bound, Index fresh) noexcept;
    void restore_cells(Index fresh);
    void require_whole();
    void clear_free_positions() noexcept {
        for (const Index i : free_indices_) strategy_->clear_position(i);
    }
    void rebuild_all(std::span<const Point> x, Move_result& report);
    [[nodiscard]] Index vertex_at(const Point& p, std::size_t bound) const;
    [[noreturn]] void throw_taken(const Point& p, std::size_t bound) const;
    void move_one(Index i, const Point& p, Move_result& report);
    void move_some(std::span<const Index> indices, std::span<const Point> points, Move_result& report);
    [[nodiscard]] bool move_one_by_one(std::span<const std::pair<Index, std::size_t>> movers,
                                       std::span<const Point> points, std::vector<std::pair<Index, Point>>& source,
                                       Move_result& report);
    static void count_movers(std::uint64_t movers, Move_counts& moves);
    void move_everything(std::span<const Point> points, Move_result& report);
    void move_sequentially(std::span<const Point> x, Move_result& report);
    void try_move_sequentially(std::span<const Point> x, Move_result& report);
    void order_by_blockers(std::span<const Point> x, std::vector<Index>& waiting) const;
    void make_trusted(Move_result& report);
    template <class Call>
    void listing_changes(Move_result& report, std::span<const Index> movers, Call call);
    template <class Call>
    void listing_all_changes(Move_result& report, Call call);

    Options options_;
    Delaunay_mesh<d>& mesh_;
    std::unique_ptr<Update_strategy<d>> strategy_;
    std::vector<Index> free_indices_;
    std::vector<Index> vertex_of_input_;
    std::unique_ptr<Change_log<d>> change_log_;  // null unless changes are reported
    bool whole_ = true;  // false: there are positions but no cells, because memory ran out twice
};

extern template class Engine<2>;
extern template class Engine<3>;

}  // namespace annulus::inline v1
