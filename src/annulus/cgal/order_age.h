// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace annulus {

/// How much longer the way from each vertex of an order to the next has become since the order was made: the way that a
/// location walks, in cells, since it was about one cell then. A vertex counts by the factor of its own gap, a power of
/// two, 64 at most: what is far away, or was very near to its neighbour, counts as one vertex and hides nothing. So nothing
/// depends on the unit of length, and a motion of all vertices together does not age an order.
template <int d>
class Order_age {
  public:
    /// These follow each other in a new order.
    void note(std::span<const Index> order, std::span<const Coordinates<d>> x);
    /// What is known is of no use where i is concerned. O(1).
    void forget(Index i) noexcept {
        if (static_cast<std::size_t>(i) < gap_.size()) gap_[static_cast<std::size_t>(i)] = unknown;
    }
    /// For that many vertices forget() and note() need no memory, and what is known stays. May throw bad_alloc.
    void reserve(std::size_t vertices) { gap_.reserve(vertices); }
    /// The factor is more than two in the mean, of a few hundred vertices. O(1).
    [[nodiscard]] bool seems_stale(std::span<const Index> order, std::span<const Coordinates<d>> x) const;
    /// Of all of them. O(n).
    [[nodiscard]] bool is_stale(std::span<const Index> order, std::span<const Coordinates<d>> x) const;

  private:
    using Exponent = std::int16_t;
    static constexpr Exponent unknown = INT16_MIN;
    static constexpr int most_doublings = 6;

    [[nodiscard]] Exponent known(Index i) const {
        return static_cast<std::size_t>(i) < gap_.size() ? gap_[static_cast<std::size_t>(i)] : unknown;
    }
    [[nodiscard]] bool is_stale(std::span<const Index> order, std::span<const Coordinates<d>> x,
                                std::size_t stride) const;

    std::vector<Exponent>
        gap_;  // by vertex: to the one that followed it, the exponent of the largest difference of coordinates
};

extern template class Order_age<2>;
extern template class Order_age<3>;

}  // namespace annulus
