// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/arrays.h>
#include <module/cells.h>
#include <module/turn.h>

#include <annulus/moving_mesh.h>

#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace annulus::python {

/// A Moving_mesh that threads of Python may share: who computes holds its lock, and not the GIL. What arrays look
/// into are copies of positions and cells, made when they are asked for and again only after they have changed.
///
/// Every member that takes or makes Python's objects is called with the GIL; while the lock is held nobody waits for
/// it.
template <int d>
class Mesh {
  public:
    using Point = Coordinates<d>;

    Mesh(const Points_in<d>& points, const Options& options);
    /// As it was pickled: `points` has rows for free indices too, `free_indices` says which these are, the one that was
    /// freed last at the end.
    Mesh(const Points_in<d>& points, std::vector<Index> free_indices, const Options& options);

    Move_report move(const Points_in<d>& points);
    Move_report move(const std::vector<Index>& indices, const Points_in<d>& points);
    /// All of them or none; memory that runs out on the way may leave more free indices.
    std::vector<Index> insert(const Points_in<d>& points);
    /// All of them or, unless memory runs out on the way, none.
    void remove(const std::vector<Index>& indices);
    Move_report recompute_tolerances();

    [[nodiscard]] py::array points();
    [[nodiscard]] py::array is_vertex() const;
    /// What it can be made again from, all of one moment: `points` as above, and which indices are free, the last
    /// one at the end.
    [[nodiscard]] std::pair<py::array, std::vector<Index>> state();
    [[nodiscard]] std::vector<Index> vertex_of_input() const;
    [[nodiscard]] std::shared_ptr<const Cells<d>> cells();
    [[nodiscard]] std::shared_ptr<const Adjacency> adjacency();
    [[nodiscard]] std::vector<Index> find(const Points_in<d>& points);

    // By vertex index, NaN at free ones.
    [[nodiscard]] std::vector<double> tolerances() const;
    [[nodiscard]] std::vector<double> thetas() const;
    [[nodiscard]] std::vector<double> displacements() const;
    [[nodiscard]] std::vector<double> voronoi_volumes();

    /// Of one moment; others may move it on while it is looked at. Looks for signals.
    [[nodiscard]] Audit_result audit() const;
    /// How many vertices, and the strategy in force, both of one moment.
    [[nodiscard]] std::pair<std::size_t, Strategy> summary() const;
    [[nodiscard]] std::size_t vertices() const;
    [[nodiscard]] std::size_t index_bound() const;
    [[nodiscard]] int dimension() const;
    [[nodiscard]] const Options& options() const { return options_; }
    [[nodiscard]] Strategy strategy() const;

  private:
    template <class Call>
    auto locked(Call call) const;
    template <class Call>
    Move_report changing(Call call);
    template <class Value>
    [[nodiscard]] std::vector<double> by_vertex(Value value) const;
    /// The lock is held.
    [[nodiscard]] std::shared_ptr<const Cells<d>> kept_cells();
    [[nodiscard]] std::shared_ptr<const std::vector<Point>> kept_points();
    void remove_one(Index i);
    void require_free(std::span<const Point> points) const;

    const Options options_;
    mutable Process_mutex lock_;
    Moving_mesh<d> mesh_;
    std::vector<Index> free_indices_;
    std::shared_ptr<const std::vector<Point>> points_;  // null once they have changed; so are the others
    std::shared_ptr<const Cells<d>> cells_;
    std::shared_ptr<const Adjacency> adjacency_;
};

extern template class Mesh<2>;
extern template class Mesh<3>;

}  // namespace annulus::python
