// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/gauss_legendre.h>

#include <boost/math/special_functions/legendre.hpp>

#include <cstddef>
#include <vector>

namespace annulus::inline v1 {

namespace {

using Real = long double;
using boost::math::legendre_p;

/// All zeros of the Legendre polynomial of degree n, ascending.
std::vector<Real> zeros(int n) {
    std::vector<Real> all;
    for (const Real x : boost::math::legendre_p_zeros<Real>(n)) {  // from 0 on
        all.push_back(x);
        if (x > 0) all.insert(all.begin(), -x);
    }
    return all;
}

/// Abramowitz and Stegun 25.4.29.
Gauss_rule legendre(int n) {
    Gauss_rule rule;
    for (const Real x : zeros(n)) {
        const Real slope = boost::math::legendre_p_prime(n, x);
        rule.node[static_cast<std::size_t>(rule.size)] = static_cast<double>((1 + x) / 2);
        rule.weight[static_cast<std::size_t>(rule.size++)] = static_cast<double>(1 / ((1 - x * x) * slope * slope));
    }
    return rule;
}

/// Radau's rule with n + 1 nodes for t f(t), which is 0 at its first node (Abramowitz and Stegun 25.4.31): zeros of
/// P_n + P_(n+1), one between each two zeros of P_(n+1), because P_n changes its sign there.
Gauss_rule radial(int n) {
    const auto sum = [n](Real x) { return legendre_p(n, x) + legendre_p(n + 1, x); };
    const std::vector<Real> between = zeros(n + 1);
    Gauss_rule rule;
    for (std::size_t i = 0; i + 1 < between.size(); ++i) {
        Real low = between[i], high = between[i + 1];
        const bool rises = sum(low) < 0;
        for (int halving = 0; halving < 80; ++halving) {
            const Real middle = (low + high) / 2;
            ((sum(middle) < 0) == rises ? low : high) = middle;
        }
        const Real t = (1 + low) / 2, p = static_cast<Real>(n + 1) * legendre_p(n, low);
        rule.node[i] = static_cast<double>(t);
        rule.weight[i] = static_cast<double>(t * (1 - t) / (p * p));
        ++rule.size;
    }
    return rule;
}

std::array<Gauss_rule, Gauss_rule::max_size> table(Gauss_rule (*make)(int)) {
    std::array<Gauss_rule, Gauss_rule::max_size> made;
    for (int n = 1; n <= Gauss_rule::max_size; ++n) made[static_cast<std::size_t>(n - 1)] = make(n);
    return made;
}

}  // namespace

const Gauss_rule& gauss_rule(int size) {
    static const auto rules = table(legendre);
    return rules[static_cast<std::size_t>(size - 1)];
}

const Gauss_rule& radial_rule(int size) {
    static const auto rules = table(radial);
    return rules[static_cast<std::size_t>(size - 1)];
}

}  // namespace annulus::inline v1
