// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/cell_lists.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/mesh/nearest.h>
#include <annulus/predicate/sure_orientation.h>
#include <annulus/space/squared_distance.h>

#include <cmath>
#include <cstdint>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// Walks from cell to cell towards a point: starts at the nearest of a few vertices, then crosses facets that have the
/// point on their other side. With exact signs such a walk through a Delaunay triangulation ends. The facet that is
/// tested first is chosen by a pseudo-random sequence that is always the same. Not walk_to (walk.h): a list has no
/// infinite cells, and may be no triangulation.
template <int d>
class List_walk {
  public:
    List_walk(const Cell_lists<d>& lists, std::span<const Coordinates<d>> x)
        : cells_(lists.cells),
          cell_of_(lists.cell_of),
          x_(x),
          stride_(1 + x.size() / static_cast<std::size_t>(3 + std::cbrt(static_cast<double>(x.size())))) {}

    [[nodiscard]] Index find(const Coordinates<d>& p) {
        if (!in_domain(p)) return outside;  // every vertex is in the domain
        Index c = start(p);
        Index from = outside;
        for (std::size_t steps = 0; steps < 2 * cells_.vertices.size() + 100; ++steps) {
            const Index next = beyond(c, from, p);
            if (next == here) return last_ = c;
            if (next == outside) {
                last_ = c;
                return outside;
            }
            from = c;
            c = next;
        }
        return search(p);
    }

  private:
    static constexpr Index outside = Mesh_cells<d>::outside;
    static constexpr Index here = -2;
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

    /// Tests all cells one after another: tolerances that are not certified may leave cells that are no triangulation,
    /// where a walk can cycle.
    [[nodiscard]] Index search(const Coordinates<d>& p) {
        for (std::size_t c = 0; c < cells_.vertices.size(); ++c)
            if (beyond(static_cast<Index>(c), here, p) == here) return static_cast<Index>(c);
        return outside;
    }

    /// The cell beyond a facet of c that separates c from the point, but never the one that the walk came from; `here`
    /// if there is none.
    [[nodiscard]] Index beyond(Index c, Index from, const Coordinates<d>& p) {
        const auto& v = cells_.vertices[at(c)];
        Tuple<d, d + 1> corners{};
        for (std::size_t i = 0; i <= d; ++i) corners[i] = &x_[at(v[i])];
        random_ = random_ * 6364136223846793005U + 1442695040888963407U;
        const std::size_t first = (random_ >> 33) % (d + 1);
        for (std::size_t k = 0; k <= d; ++k) {
            const std::size_t i = (first + k) % (d + 1);
            const Index next = cells_.neighbours[at(c)][i];
            if (next == from && next >= 0) continue;
            const auto* const corner = std::exchange(corners[i], &p);
            const bool out = sure_orientation<d>(corners) < 0;
            corners[i] = corner;
            if (out) return next;
        }
        return here;
    }

    [[nodiscard]] Index start(const Coordinates<d>& p) const {
        const Index last = last_ >= 0 ? last_ : 0;
        Nearest<Index> cell(last);
        cell.offer(last, squared_distance<d>(x_[at(cells_.vertices[at(last)][0])], p));
        for (std::size_t v = 0; v < x_.size(); v += stride_)
            if (cell_of_[v] >= 0) cell.offer(cell_of_[v], squared_distance<d>(x_[v], p));
        return cell.item();
    }

    const Mesh_cells<d>& cells_;
    const std::vector<Index>& cell_of_;
    std::span<const Coordinates<d>> x_;
    std::size_t stride_;
    std::uint64_t random_ = 1;
    Index last_ = outside;
};

}  // namespace

template <int d>
void find_cells(const Cell_lists<d>& lists, std::span<const Coordinates<d>> x, std::span<const Coordinates<d>> points,
                std::span<Index> out) {
    if (lists.dimension != d || lists.cells.vertices.empty()) {
        for (Index& c : out) c = Mesh_cells<d>::outside;
        return;
    }
    List_walk<d> walk(lists, x);
    for (std::size_t k = 0; k < points.size(); ++k) out[k] = walk.find(points[k]);
}

template void find_cells(const Cell_lists<2>&, std::span<const Coordinates<2>>, std::span<const Coordinates<2>>,
                         std::span<Index>);
template void find_cells(const Cell_lists<3>&, std::span<const Coordinates<3>>, std::span<const Coordinates<3>>,
                         std::span<Index>);

}  // namespace annulus::inline v1
