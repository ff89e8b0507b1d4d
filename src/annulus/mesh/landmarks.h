// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/internal/index.h>
#include <annulus/mesh/nearest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/// Where walks begin: some of the vertices, sorted by position as a k-d tree, in which one near any position is found
/// in O(log n), and the vertex where the last walk ended. All of them are hints: vertices may move or be removed
/// without notice.
///
/// The number of landmarks follows the number of steps by which walks have been too long, up to one vertex in `share`.
/// So one insertion into a million vertices sorts nothing, and thousands of them walk a few steps each. When walks
/// become long again, because vertices were added, removed or moved, the tree is rebuilt, which costs about as much as
/// these walks did.
template <int d>
class Landmarks {
  public:
    /// The vertex nearest to p among `own` (a vertex or `none`), the vertex of the last walk, and some landmarks
    /// around p, as far as is_present() confirms them; `none` when it confirms none. The vertices are the indices v
    /// below `bound` with is_present(v), and x their positions. O(log n), beside the cost of the rebuild above.
    template <class Is_present>
    [[nodiscard]] Index near(std::span<const Coordinates<d>> x, std::size_t bound, const Coordinates<d>& p, Index own,
                             Is_present is_present) {
        if (excess_ > few + 2 * tree_.size()) renew(x, bound, is_present);
        Nearest<Index> nearest(none);
        const auto look = [&](Index v) {
            if (v == none || static_cast<std::size_t>(v) >= bound || !is_present(v)) return;
            nearest.offer(v, distance(x[static_cast<std::size_t>(v)], p));
        };
        look(own);
        look(last_);
        const auto [first, end] = leaf(p);
        for (std::size_t k = first; k < end; ++k)
            if (nearest.takes(distance(tree_[k].place, p))) look(tree_[k].vertex);
        return nearest.item();
    }

    /// A walk that began where near() said took so many steps, and ended at v.
    void note(Index v, std::size_t steps) noexcept {
        last_ = v;
        crossed_ += steps;
        if (steps > usual) excess_ += steps - usual;
    }

    /// Facets crossed by all walks so far: the cost of locating.
    [[nodiscard]] std::uint64_t crossed() const noexcept { return crossed_; }

    /// The vertex of a cell nearest to p, other than infinity and `but`; or none.
    [[nodiscard]] static Index nearest(std::span<const Coordinates<d>> x,
                                       const std::array<Index, static_cast<std::size_t>(d + 1)>& cell,
                                       const Coordinates<d>& p, Index but) {
        Nearest<Index> nearest(none);
        for (const Index v : cell)
            if (v != infinite && v != but) nearest.offer(v, distance(x[static_cast<std::size_t>(v)], p));
        return nearest.item();
    }
    /// The sum of the differences, since squares would overflow and underflow.
    [[nodiscard]] static double distance(const Coordinates<d>& a, const Coordinates<d>& b) {
        double sum = 0.0;
        for (std::size_t k = 0; k < d; ++k) sum += std::fabs(a[k] - b[k]);
        return sum;
    }

  private:
    static constexpr std::size_t share = 16;
    static constexpr std::size_t few = 64;
    static constexpr std::size_t usual =
        d == 2 ? 16 : 24;                     // steps that a walk from the nearest of one in `share` takes, or less
    static constexpr std::size_t bucket = 8;  // landmarks of a leaf, at most

    struct Landmark {
        Coordinates<d> place;  // its position when the tree was built
        Index vertex;
    };
    /// How a range was divided at its middle landmark: the ones after it follow it along this axis.
    struct Split {
        Coordinates<d> place;
        std::size_t axis;
    };

    /// Ties along the axis are broken by the next axis, and so on. So points on a wall are divided evenly, too.
    [[nodiscard]] static bool precedes(const Coordinates<d>& l, const Coordinates<d>& r, std::size_t axis) {
        for (std::size_t k = 0; k < d; ++k, axis = (axis + 1) % d)
            if (l[axis] != r[axis]) return l[axis] < r[axis];
        return false;
    }

    /// Draws one vertex from each of `count` runs of indices. Drawn at random, since indices may be in an order that
    /// depends on positions.
    template <class Is_present>
    void renew(std::span<const Coordinates<d>> x, std::size_t bound, Is_present is_present) {
        const std::size_t count = std::min(bound / share + 1, excess_);
        excess_ = 0;
        tree_.clear();
        split_.clear();
        tree_.reserve(count);
        split_.reserve(count);  // here, so that the two agree whatever throws
        std::uint64_t random = 1;
        for (std::size_t k = 0; k < count; ++k) {
            random = random * 6364136223846793005U + 1442695040888963407U;
            const std::size_t run = k * bound / count;
            const std::size_t length = (k + 1) * bound / count - run;
            const std::size_t v = run + (length > 0 ? (random >> 33) % length : 0);
            if (v < bound && is_present(static_cast<Index>(v))) tree_.push_back({x[v], static_cast<Index>(v)});
        }
        split_.resize(tree_.size());
        divide(0, tree_.size());
    }

    /// Moves the median of [first, end) along the axis of largest extent to the middle, and so on for both halves.
    void divide(std::size_t first, std::size_t end) {
        if (end - first <= bucket) return;
        Coordinates<d> low = tree_[first].place;
        Coordinates<d> high = low;
        for (std::size_t k = first + 1; k < end; ++k)
            for (std::size_t i = 0; i < d; ++i) {
                low[i] = std::min(low[i], tree_[k].place[i]);
                high[i] = std::max(high[i], tree_[k].place[i]);
            }
        std::size_t axis = 0;
        for (std::size_t i = 1; i < d; ++i)
            if (high[i] - low[i] > high[axis] - low[axis]) axis = i;
        const std::size_t middle = middle_of(first, end);
        const auto at = [this](std::size_t k) { return tree_.begin() + static_cast<std::ptrdiff_t>(k); };
        std::nth_element(at(first), at(middle), at(end),
                         [axis](const Landmark& l, const Landmark& r) { return precedes(l.place, r.place, axis); });
        split_[middle] = {tree_[middle].place, axis};
        divide(first, middle);
        divide(middle, end);
    }
    [[nodiscard]] static std::size_t middle_of(std::size_t first, std::size_t end) { return first + (end - first) / 2; }

    /// The leaf that p belongs to, as a range of tree_.
    [[nodiscard]] std::pair<std::size_t, std::size_t> leaf(const Coordinates<d>& p) const {
        std::size_t first = 0;
        std::size_t end = tree_.size();
        while (end - first > bucket) {
            const std::size_t middle = middle_of(first, end);
            if (precedes(p, split_[middle].place, split_[middle].axis)) end = middle;
            else first = middle;
        }
        return {first, end};
    }

    std::vector<Landmark> tree_;
    std::vector<Split> split_;   // by the middle landmark
    std::size_t excess_ = 0;     // steps beyond the usual since the tree was made
    std::uint64_t crossed_ = 0;  // facets, by all walks
    Index last_ = none;
};

}  // namespace annulus::inline v1
