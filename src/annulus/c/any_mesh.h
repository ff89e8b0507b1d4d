// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/audit.h>
#include <annulus/mesh/cell_lists.h>
#include <annulus/options.h>
#include <annulus/types.h>

#include <cstddef>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace annulus::inline v1::c {

/// Cells as plain numbers, dimension + 1 per cell; valid as long as this object exists.
struct Cells {
    std::shared_ptr<const void> kept;
    const Index* vertices = nullptr;
    const Index* neighbours = nullptr;
    std::size_t count = 0;
};

/// A Moving_mesh of either dimension, as plain arrays. Precondition of every member: the caller has checked sizes.
/// Throws what Moving_mesh throws; const members may run concurrently.
class Any_mesh {
  public:
    virtual ~Any_mesh() = default;

    [[nodiscard]] virtual int dimension() const = 0;
    [[nodiscard]] virtual int affine_dimension() const = 0;
    [[nodiscard]] virtual std::size_t vertices() const = 0;
    [[nodiscard]] virtual std::size_t index_bound() const = 0;
    [[nodiscard]] virtual bool is_vertex(Index i) const = 0;
    [[nodiscard]] virtual Strategy strategy() const = 0;
    [[nodiscard]] virtual const Options& options() const = 0;
    [[nodiscard]] virtual std::span<const Index> vertex_of_input() const = 0;

    virtual Move_result move_all(const double* x, std::size_t points) = 0;
    virtual Move_result move(std::span<const Index> indices, const double* x) = 0;
    /// Throws not_finite or out_of_domain unless each of these points may be a position.
    virtual void require_positions(const double* x, std::size_t points) const = 0;
    virtual Index insert(const double* x, Move_result& report) = 0;
    virtual void remove(Index i, Move_result& report) = 0;
    virtual Move_result recompute_tolerances() = 0;

    virtual void points(double* x) const = 0;
    virtual void tolerances(double* lengths) const = 0;
    virtual void displacements(double* lengths) const = 0;
    /// Either array may be null.
    virtual void voronoi(double* volumes, Index* neighbour_counts) const = 0;
    /// `box` has the lower and the upper corner, or is null. Either array may be null.
    virtual void voronoi_cells(const double* box, double* volumes, double* centroids) const = 0;
    virtual void voronoi_gradient(const double* weights, double* gradient) const = 0;
    /// In the order of neighbour_lists(). Either array may be null.
    virtual void voronoi_facets(double* measures, double* centroids) const = 0;
    // Lists are made once after a change of the mesh and then reused.
    [[nodiscard]] virtual Cells cells() const = 0;
    /// Valid until the next call that is not const. Throws unknown_vertex.
    [[nodiscard]] virtual std::span<const Index> neighbours(Index v) const = 0;
    [[nodiscard]] virtual std::shared_ptr<const Vertex_neighbours> neighbour_lists() const = 0;
    /// `dimension` vertices for each facet.
    [[nodiscard]] virtual std::vector<Index> hull() const = 0;
    virtual void find_cells(const double* x, std::size_t points, Index* cells) const = 0;
    [[nodiscard]] virtual Audit_result audit() const = 0;
};

/// Precondition: dimension is 2 or 3.
[[nodiscard]] std::unique_ptr<Any_mesh> make_mesh(int dimension, const double* x, std::size_t points,
                                                  const Options& options);

}  // namespace annulus::inline v1::c
