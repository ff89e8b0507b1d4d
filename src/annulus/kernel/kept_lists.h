// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/delaunay_mesh.h>
#include <annulus/mesh/cell_lists.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The lists of a mesh: cells, neighbours of vertices, hull. Each is made on request and kept until a cell is written
/// to (Corner_table::writes); while all vertices are in a hyperplane, where the mesh has no cells, until the next call
/// that may change it. Members may be called by several threads at once, while the mesh does not change. A list that
/// a caller holds stays as it is.
template <int d>
class Kept_lists {
  public:
    using Positions = std::span<const Coordinates<d>>;
    using Facets = std::vector<std::array<Index, static_cast<std::size_t>(d)>>;

    /// The mesh must outlive it. O(1).
    explicit Kept_lists(const Delaunay_mesh<d>& mesh) : mesh_(mesh) {}

    /// To be called before each call that may change the mesh.
    void note_call() noexcept { ++calls_; }

    /// The lists of the mesh, which is Delaunay at x. O(n) after a change, otherwise O(1).
    [[nodiscard]] std::shared_ptr<const Cell_lists<d>> cells(Positions x) const;
    [[nodiscard]] std::shared_ptr<const Vertex_neighbours> neighbours(Positions x) const;
    [[nodiscard]] std::shared_ptr<const Facets> hull(Positions x) const;

  private:
    /// What the kept lists are lists of.
    struct State {
        std::uint64_t writes;
        std::uint64_t calls;
        friend bool operator==(const State&, const State&) = default;
    };
    [[nodiscard]] State state() const noexcept { return {mesh_.table().writes(), mesh_.dimension() == d ? 0 : calls_}; }
    const std::shared_ptr<const Cell_lists<d>>& listed(Positions x) const;

    const Delaunay_mesh<d>& mesh_;
    std::uint64_t calls_ = 1;
    mutable std::mutex listing_;
    mutable State kept_{};
    mutable std::shared_ptr<const Cell_lists<d>> cells_;  // null: no list is kept
    mutable std::shared_ptr<const Vertex_neighbours> neighbours_;
    mutable std::shared_ptr<const Facets> hull_;
};

extern template class Kept_lists<2>;
extern template class Kept_lists<3>;

}  // namespace annulus::inline v1
