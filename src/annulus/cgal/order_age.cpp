// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cgal/order_age.h>

#include <algorithm>
#include <cmath>

namespace annulus {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Of the largest difference: no square, which would underflow. Of 0, which collisions have, less than any other.
template <int d>
int gap_exponent(const Coordinates<d>& p, const Coordinates<d>& q) {
    double most = 0.0;
    for (std::size_t k = 0; k < p.size(); ++k) most = std::max(most, std::fabs(p[k] - q[k]));
    constexpr int least = -1100;
    return most > 0.0 ? std::ilogb(most) : least;
}

}  // namespace

template <int d>
void Order_age<d>::note(std::span<const Index> order, std::span<const Coordinates<d>> x) {
    if (gap_.size() < x.size()) gap_.resize(x.size(), unknown);
    for (std::size_t k = 0; k < order.size(); ++k)
        gap_[at(order[k])] = k + 1 < order.size()
                                 ? static_cast<Exponent>(gap_exponent<d>(x[at(order[k])], x[at(order[k + 1])]))
                                 : unknown;
}

template <int d>
bool Order_age<d>::is_stale(std::span<const Index> order, std::span<const Coordinates<d>> x, std::size_t stride) const {
    constexpr std::uint64_t unit = 8;  // of a factor that is 1
    std::uint64_t factors = 0, counted = 0;
    for (std::size_t k = 0; k + 1 < order.size(); k += stride) {
        const Index here = order[k], next = order[k + 1];
        if (known(here) == unknown || known(next) == unknown || at(here) >= x.size() || at(next) >= x.size()) continue;
        const int doublings = gap_exponent<d>(x[at(here)], x[at(next)]) - known(here);
        factors += doublings < 0 ? unit / 2 : unit << std::min(doublings, most_doublings);
        ++counted;
    }
    return factors > 2 * unit * counted;
}

template <int d>
bool Order_age<d>::seems_stale(std::span<const Index> order, std::span<const Coordinates<d>> x) const {
    constexpr std::size_t most_asked = 256;
    return is_stale(order, x, 1 + order.size() / most_asked);
}

template <int d>
bool Order_age<d>::is_stale(std::span<const Index> order, std::span<const Coordinates<d>> x) const {
    return is_stale(order, x, 1);
}

template class Order_age<2>;
template class Order_age<3>;

}  // namespace annulus
