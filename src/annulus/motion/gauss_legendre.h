// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace annulus {

/// Gauss-Legendre rule on [0, 1]: the sum of weight[i] f(node[i]), i < size, is the integral of f, exactly (up to
/// rounding) for polynomials of degree 2 size - 1.
struct Gauss_rule {
    static constexpr int max_size = 16;
    int size = 0;
    std::array<double, max_size> node{};
    std::array<double, max_size> weight{};
};

/// The rule with `size` nodes, 1 <= size <= 16. Nodes and weights are good to an ulp or two. The table is made once.
[[nodiscard]] const Gauss_rule& gauss_rule(int size);

}  // namespace annulus
