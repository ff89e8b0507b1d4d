// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cgal/order_age.h>

#include <annulus/engine/displacement.h>

#include <cstddef>

namespace annulus {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }
/// Every so many of them.
std::size_t stride(std::span<const Index> order) { return 1 + order.size() / 64; }

}  // namespace

template <int d>
void Order_age<d>::note(std::span<const Index> order, std::span<const Coordinates<d>> x) {
    noted_.clear();
    gaps_ = 0.0;
    for (std::size_t k = 0; k + 1 < order.size(); k += stride(order)) {
        noted_.push_back(x[at(order[k])]);
        gaps_ += squared_distance<d>(noted_.back(), x[at(order[k + 1])]);
    }
}

template <int d>
bool Order_age<d>::is_stale(std::span<const Index> order, std::span<const Coordinates<d>> x) const {
    double ways = 0.0;
    for (std::size_t k = 0, i = 0; i < noted_.size(); k += stride(order), ++i)
        ways += squared_distance<d>(noted_[i], x[at(order[k])]);
    return ways > 9.0 * gaps_;
}

template class Order_age<2>;
template class Order_age<3>;

}  // namespace annulus
