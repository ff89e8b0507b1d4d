// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <module/arrays.h>
#include <module/finalizing.h>
#include <module/process_mutex.h>

#include <annulus/moving_mesh.h>

#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace annulus::python {

/// A Moving_mesh that threads of Python may share: a thread that computes holds its lock, and not the GIL. Arrays refer
/// to copies of positions and cells, which are made on access, and again only after positions or cells have changed.
///
/// Members that take or create Python objects are called with the GIL. No thread waits for the GIL while it holds the
/// lock.
template <int d>
class Mesh {
  public:
    using Point = Coordinates<d>;

    Mesh(const Points_in<d>& points, const Options& options);
    /// From a pickled state: `points` also has rows for free indices; `free_indices` lists these, the one that was
    /// freed last at the end.
    Mesh(const Points_in<d>& points, std::vector<Index> free_indices, const Options& options);

    Move_result move(const Points_in<d>& points);
    Move_result move(const std::vector<Index>& indices, const Points_in<d>& points);
    /// Inserts all points or none; if memory runs out half way, there may be more free indices than before.
    std::vector<Index> insert(const Points_in<d>& points);
    /// Removes all vertices or none, unless memory runs out half way.
    void remove(const std::vector<Index>& indices);
    Move_result recompute_tolerances();

    // For batches, whose entries are computed by several threads after one release of the GIL: called without it.
    Mesh(const Without_gil&, std::span<const Point> points, const Options& options);
    Move_result move(const Without_gil& without_gil, std::span<const Point> points);
    template <class Read>
    [[nodiscard]] auto read(const Without_gil& without_gil, Read read) const;

    [[nodiscard]] py::array points();
    [[nodiscard]] py::array is_vertex() const;
    /// The state for pickling, as one snapshot: `points` as above, and the free indices, the one freed last at the end.
    [[nodiscard]] std::pair<py::array, std::vector<Index>> state();
    [[nodiscard]] std::vector<Index> vertex_of_input() const;
    [[nodiscard]] std::shared_ptr<const Cell_lists<d>> cells() const;
    [[nodiscard]] std::shared_ptr<const Vertex_neighbours> neighbours() const;
    [[nodiscard]] std::vector<std::array<Index, static_cast<std::size_t>(d)>> hull() const;
    [[nodiscard]] std::vector<Index> find(const Points_in<d>& points) const;

    // By vertex index, NaN at free indices.
    [[nodiscard]] std::vector<double> tolerances() const;
    [[nodiscard]] std::vector<double> thetas() const;
    [[nodiscard]] std::vector<double> displacements() const;
    [[nodiscard]] std::vector<double> voronoi_volumes();

    /// What read(const Moving_mesh<d>&) returns, at one moment. It runs without the GIL (mesh_locked.h).
    template <class Read>
    [[nodiscard]] auto read(Read read) const;
    /// Audits a snapshot; other threads may move vertices during the audit. Handles signals.
    [[nodiscard]] Audit_result audit() const;
    /// The number of vertices and the strategy in use, at the same moment.
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
    auto locked(const Without_gil& without_gil, Call call) const;
    template <class Call>
    Move_result changing(Call call);
    template <class Call>
    Move_result changing(const Without_gil& without_gil, Call call);
    template <class Value>
    [[nodiscard]] std::vector<double> by_vertex(Value value) const;
    /// Precondition: this thread holds the lock.
    [[nodiscard]] std::shared_ptr<const std::vector<Point>> kept_points();
    void remove_one(Index i);
    void require_free(std::span<const Point> points) const;

    const Options options_;
    mutable Process_mutex lock_;
    Moving_mesh<d> mesh_;
    std::vector<Index> free_indices_;
    std::shared_ptr<const std::vector<Point>> points_;  // null after a change
};

extern template class Mesh<2>;
extern template class Mesh<3>;

}  // namespace annulus::python
