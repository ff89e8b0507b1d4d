// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/gauss_legendre.h>

#include <cmath>
#include <cstddef>
#include <numbers>

namespace annulus {

namespace {

/// Newton's method on the Legendre polynomial in long double, from the classical starting values
/// cos(pi (i + 3/4) / (n + 1/2)); Abramowitz and Stegun 25.4.29 and 22.16.6.
Gauss_rule make_rule(int n) {
    using Real = long double;
    Gauss_rule rule;
    rule.size = n;
    for (int i = 0; i < n; ++i) {
        Real x = std::cos(std::numbers::pi_v<Real> * (Real(i) + 0.75L) / (Real(n) + 0.5L)), slope = 1;
        for (int iteration = 0; iteration < 20; ++iteration) {
            Real before = 0, value = 1;
            for (int k = 1; k <= n; ++k) {
                const Real next = (Real(2 * k - 1) * x * value - Real(k - 1) * before) / Real(k);
                before = value;
                value = next;
            }
            slope = Real(n) * (x * value - before) / (x * x - 1);
            x -= value / slope;
        }
        // Ascending nodes: the starting values descend.
        const auto at = static_cast<std::size_t>(n - 1 - i);
        rule.node[at] = static_cast<double>((1 + x) / 2);
        rule.weight[at] = static_cast<double>(1 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

}  // namespace

const Gauss_rule& gauss_rule(int size) {
    static const auto rules = [] {
        std::array<Gauss_rule, Gauss_rule::max_size> made;
        for (int n = 1; n <= Gauss_rule::max_size; ++n) made[static_cast<std::size_t>(n - 1)] = make_rule(n);
        return made;
    }();
    return rules[static_cast<std::size_t>(size - 1)];
}

}  // namespace annulus
