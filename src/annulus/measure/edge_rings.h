// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// The cells around one edge of a triangulation.
struct Edge_ring {
    Index i, j;                    ///< i < j
    std::span<const Index> cells;  ///< in 3D in order, counter-clockwise seen from j; in 2D one or two
    /// Of each cell the corner opposite to the facet that leads to the next one; in 2D of the first.
    std::span<const char> crossing;
    bool open;  ///< the edge is in the hull: the facet before the first cell and that after the last one are
};

/// By edge of a cell in 3D: corners a, b, k, l, an even permutation. The cells around the edge from a to b,
/// counter-clockwise seen from b, go on beyond the facet opposite to k.
inline constexpr std::size_t edge_corners[6][4] = {{0, 1, 2, 3}, {0, 2, 3, 1}, {0, 3, 1, 2},
                                                   {1, 2, 0, 3}, {1, 3, 2, 0}, {2, 3, 0, 1}};

/// Visits every edge of a triangulation once: of points that span d dimensions. O(n). Throws bad_input where neighbours
/// have no facet in common, or the cells around an edge do not form one ring.
template <int d>
class Edge_rings {
  public:
    explicit Edge_rings(const Mesh_cells<d>& cells) : cells_(cells) {
        if constexpr (d == 3) done_.assign(cells.vertices.size(), 0);
    }

    template <class Visit>
    void for_each(Visit visit) {
        const auto all = [](Index, Index) { return true; };
        for (std::size_t c = 0; c < cells_.vertices.size(); ++c) visit_edges(static_cast<Index>(c), all, visit);
    }
    /// The edges that are wanted(i, j), symmetric in both, in the same order. `cells` are all cells with such an edge,
    /// and perhaps others; they ascend.
    template <class Wanted, class Visit>
    void for_each_of(std::span<const Index> cells, Wanted wanted, Visit visit) {
        for (const Index c : cells) visit_edges(c, wanted, visit);
    }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }

    /// A cell and its corners a, b, k, l, an even permutation: the edge a b, then a step from k to l.
    struct Step {
        Index cell;
        std::size_t a, b, k, l;
    };

    template <class Wanted, class Visit>
    void visit_edges(Index c, Wanted& wanted, Visit& visit) {
        if constexpr (d == 2) visit_sides(c, wanted, visit);
        else
            for (std::size_t e = 0; e < 6; ++e)
                if ((done_[at(c)] >> e & 1) == 0 &&
                    wanted(cells_.vertices[at(c)][edge_corners[e][0]], cells_.vertices[at(c)][edge_corners[e][1]]))
                    visit(ring_of(c, e));
    }

    template <class Wanted, class Visit>
    void visit_sides(Index c, Wanted& wanted, Visit& visit) const {
        for (std::size_t k = 0; k < 3; ++k) {
            const Index n = cells_.neighbours[at(c)][k];
            const Index p = cells_.vertices[at(c)][(k + 1) % 3];
            const Index q = cells_.vertices[at(c)][(k + 2) % 3];
            if (n != cells_.outside && !shares(n, p, q, c)) refuse(c);
            if ((n != cells_.outside && n < c) || !wanted(p, q)) continue;
            const bool open = n == cells_.outside;
            const std::array<Index, 2> both{c, n};
            const char crossing = static_cast<char>(k);
            visit(Edge_ring{std::min(p, q), std::max(p, q), std::span(both).first(open ? 1 : 2), {&crossing, 1}, open});
        }
    }

    /// Whether the edge from q to p of cell n has cell c beyond it.
    [[nodiscard]] bool shares(Index n, Index p, Index q, Index c) const {
        const auto& v = cells_.vertices[at(n)];
        for (std::size_t k = 0; k < 3; ++k)
            if (v[(k + 1) % 3] == q && v[(k + 2) % 3] == p) return cells_.neighbours[at(n)][k] == c;
        return false;
    }

    /// The cell beyond the facet opposite to corner `across`, where this is s.k (forward) or s.l; its other corner.
    [[nodiscard]] Step next(const Step& s, bool forward) const {
        const auto& v = cells_.vertices[at(s.cell)];
        Step out{cells_.neighbours[at(s.cell)][forward ? s.k : s.l], 0, 0, 0, 0};
        if (out.cell == cells_.outside) return out;
        const auto& w = cells_.vertices[at(out.cell)];
        const Index kept = v[forward ? s.l : s.k];
        std::size_t of_kept = 0;
        unsigned found = 0;
        for (std::size_t n = 0; n < 4; ++n) {
            if (w[n] == v[s.a]) out.a = n, found |= 1;
            else if (w[n] == v[s.b]) out.b = n, found |= 2;
            else if (w[n] == kept) of_kept = n, found |= 4;
        }
        if (found != 7) refuse(s.cell);
        const std::size_t other = 6 - out.a - out.b - of_kept;
        if (cells_.neighbours[at(out.cell)][other] != s.cell) refuse(s.cell);
        out.k = forward ? of_kept : other;
        out.l = forward ? other : of_kept;
        return out;
    }

    [[noreturn]] static void refuse(Index c) {
        throw Error(Error_code::bad_input, "neighbours of cell " + std::to_string(c) + " do not go round an edge");
    }
    /// Of an edge that has been visited already there is another ring.
    void mark(const Step& s) {
        const std::size_t low = std::min(s.a, s.b);
        const std::size_t high = std::max(s.a, s.b);
        const auto bit = static_cast<unsigned char>(1U << (low == 0 ? high - 1 : low + high));
        if ((done_[at(s.cell)] & bit) != 0) refuse(s.cell);
        done_[at(s.cell)] |= bit;
    }

    Edge_ring ring_of(Index c, std::size_t e) {
        Step s{c, edge_corners[e][0], edge_corners[e][1], edge_corners[e][2], edge_corners[e][3]};
        if (cells_.vertices[at(c)][s.a] > cells_.vertices[at(c)][s.b]) {
            std::swap(s.a, s.b);
            std::swap(s.k, s.l);
        }
        const Index i = cells_.vertices[at(c)][s.a];
        const Index j = cells_.vertices[at(c)][s.b];
        ring_.clear();
        crossing_.clear();
        Step t = s;
        bool open = false;
        do {
            note(t);
            t = next(t, true);
            open = t.cell == cells_.outside;
        } while (!open && t.cell != c);
        if (!open && (t.k != s.k || t.l != s.l)) refuse(c);
        if (open) {
            const auto seen = static_cast<std::ptrdiff_t>(ring_.size());
            for (t = next(s, false); t.cell != cells_.outside; t = next(t, false)) note(t);
            std::reverse(ring_.begin() + seen, ring_.end());
            std::reverse(crossing_.begin() + seen, crossing_.end());
            std::rotate(ring_.begin(), ring_.begin() + seen, ring_.end());
            std::rotate(crossing_.begin(), crossing_.begin() + seen, crossing_.end());
        }
        return {i, j, ring_, crossing_, open};
    }
    void note(const Step& s) {
        ring_.push_back(s.cell);
        crossing_.push_back(static_cast<char>(s.k));
        mark(s);
    }

    const Mesh_cells<d>& cells_;
    std::vector<unsigned char> done_;  // a bit for each edge of a cell
    std::vector<Index> ring_;
    std::vector<char> crossing_;
};

}  // namespace annulus::inline v1
