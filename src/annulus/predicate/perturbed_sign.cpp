// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/predicate/perturbed_sign.h>

#include <annulus/predicate/sure_orientation.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// The cell of all points but slot d is positive, and slot d is tested against its sphere. The perturbation of the
/// lexicographically largest point dominates; its coefficient is an orientation of the others. In 3D the two largest
/// suffice: if the first coefficient is 0, its four points lie on a plane that contains no fifth.
template <int d>
int perturbed(const Tuple<d, d + 2>& x) {
    constexpr std::size_t tested = d, last = d + 1;
    std::array<std::size_t, d + 2> order{};
    for (std::size_t k = 0; k <= last; ++k) order[k] = k;
    std::swap(order[tested], order[last]);
    std::sort(order.begin(), order.end(), [&](std::size_t k, std::size_t l) { return precedes(x, k, l); });
    for (std::size_t i = last; i > 0; --i) {
        if (order[i] == tested) return 1;
        Tuple<d, d + 1> replaced{};  // the cell with that point in place of a corner
        std::copy_n(x.begin(), d, replaced.begin());
        replaced[tested] = x[last];
        replaced[std::min(order[i], tested)] = x[tested];
        if (const int inside = sure_orientation<d>(replaced); inside != 0) return -inside;
    }
    return 1;
}

}  // namespace

int perturbed_sign(const Tuple<2, 4>& x) { return perturbed<2>(x); }
int perturbed_sign(const Tuple<3, 5>& x) { return perturbed<3>(x); }

}  // namespace annulus::inline v1
