// SPDX-License-Identifier: GPL-3.0-or-later
#include <module/cells.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/predicate/filtered.h>

#include <cmath>
#include <cstdint>
#include <utility>

namespace annulus::python {

namespace {

/// Walks from simplex to simplex towards a point: starts at the nearest of a few vertices, then crosses facets that
/// have the point on their other side. With exact signs such a walk through a Delaunay triangulation terminates. The
/// facet that is tested first is chosen by a pseudo-random sequence that is always the same.
template <int d>
class Walk {
  public:
    Walk(const Cells<d>& cells, std::span<const Coordinates<d>> vertices)
        : cells_(cells),
          vertices_(vertices),
          stride_(1 + vertices.size() / static_cast<std::size_t>(3 + std::cbrt(static_cast<double>(vertices.size())))) {
    }

    [[nodiscard]] Index find(const Coordinates<d>& p) {
        if (cells_.simplices.vertices.empty() || !in_domain(p)) return -1;  // every vertex is in the domain
        Index s = start(p), from = -1;
        for (std::size_t steps = 0; steps < 2 * cells_.simplices.vertices.size() + 100; ++steps) {
            const Index next = beyond(s, from, p);
            if (next == here) return last_ = s;
            if (next == Mesh_cells<d>::outside) {
                last_ = s;
                return -1;
            }
            from = s;
            s = next;
        }
        return search(p);
    }

  private:
    static constexpr Index here = -2;

    /// Tests all simplices one after another: tolerances that are not certified may leave cells that are no
    /// triangulation, where a walk can cycle.
    [[nodiscard]] Index search(const Coordinates<d>& p) {
        for (std::size_t s = 0; s < cells_.simplices.vertices.size(); ++s)
            if (beyond(static_cast<Index>(s), here, p) == here) return static_cast<Index>(s);
        return -1;
    }

    /// The simplex beyond a facet of s that separates s from the point, but never the one that the walk came from;
    /// `here` if there is none.
    [[nodiscard]] Index beyond(Index s, Index from, const Coordinates<d>& p) {
        const auto& v = cells_.simplices.vertices[at(s)];
        Tuple<d, d + 1> x{};
        for (std::size_t i = 0; i <= d; ++i) x[i] = &vertices_[at(v[i])];
        random_ = random_ * 6364136223846793005U + 1442695040888963407U;
        const std::size_t first = (random_ >> 33) % (d + 1);
        for (std::size_t k = 0; k <= d; ++k) {
            const std::size_t i = (first + k) % (d + 1);
            const Index next = cells_.simplices.neighbours[at(s)][i];
            if (next == from && next >= 0) continue;
            const auto* const corner = std::exchange(x[i], &p);
            const bool out = evaluate_orientation(x, false).sign < 0;
            x[i] = corner;
            if (out) return next;
        }
        return here;
    }

    [[nodiscard]] Index start(const Coordinates<d>& p) const {
        double least = HUGE_VAL;
        Index best = last_ >= 0 ? last_ : 0;
        const auto look = [&](std::size_t v, Index simplex) {
            double square = 0;
            for (std::size_t k = 0; k < d; ++k) square += (vertices_[v][k] - p[k]) * (vertices_[v][k] - p[k]);
            if (square < least) {
                least = square;
                best = simplex;
            }
        };
        look(at(cells_.simplices.vertices[at(best)][0]), best);
        for (std::size_t v = 0; v < vertices_.size(); v += stride_)
            if (cells_.simplex_of[v] >= 0) look(v, cells_.simplex_of[v]);
        return best;
    }

    const Cells<d>& cells_;
    std::span<const Coordinates<d>> vertices_;
    std::size_t stride_;
    std::uint64_t random_ = 1;
    Index last_ = -1;
};

}  // namespace

template <int d>
void find_simplices(const Cells<d>& cells, std::span<const Coordinates<d>> vertices,
                    std::span<const Coordinates<d>> points, std::span<Index> out) {
    Walk<d> walk(cells, vertices);
    for (std::size_t k = 0; k < points.size(); ++k) out[k] = walk.find(points[k]);
}

template void find_simplices(const Cells<2>&, std::span<const Coordinates<2>>, std::span<const Coordinates<2>>,
                             std::span<Index>);
template void find_simplices(const Cells<3>&, std::span<const Coordinates<3>>, std::span<const Coordinates<3>>,
                             std::span<Index>);

}  // namespace annulus::python
