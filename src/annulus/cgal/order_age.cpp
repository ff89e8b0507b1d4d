// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cgal/order_age.h>

#include <annulus/engine/displacement.h>

#include <cstddef>

namespace annulus {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }
constexpr std::size_t most_noted = 64;

}  // namespace

template <int d>
void Order_age<d>::note(std::span<const Index> order, std::span<const Coordinates<d>> x) {
    noted_.clear();
    for (std::size_t k = 0; k + 1 < order.size(); k += 1 + order.size() / most_noted) {
        const Coordinates<d>& here = x[at(order[k])];
        noted_.push_back({order[k], here, squared_distance<d>(here, x[at(order[k + 1])])});
    }
}

template <int d>
bool Order_age<d>::is_stale(std::span<const Coordinates<d>> x) const {
    double ways = 0.0, gaps = 0.0;
    for (const Noted& one : noted_) {
        ways += squared_distance<d>(one.position, x[at(one.vertex)]);
        gaps += one.gap;
    }
    return ways > 1.0 * gaps;
}

template class Order_age<2>;
template class Order_age<3>;

}  // namespace annulus
