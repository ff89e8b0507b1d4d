// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace annulus::inline v1 {

/// Nodes and weights on [0, 1]: the sum of weight[i] f(node[i]), i < size, is the integral of f times the rule's
/// weight function, exactly (up to rounding) for polynomials of degree 2 size - 1.
struct Gauss_rule {
    static constexpr int max_size = 12;
    int size = 0;
    std::array<double, max_size> node{};
    std::array<double, max_size> weight{};
};

/// Gauss-Legendre, the weight function 1; 1 <= size <= 12. Nodes and weights are accurate to an ulp or two. The table
/// is made once.
[[nodiscard]] const Gauss_rule& gauss_rule(int size);

/// Gauss-Jacobi for the weight function t, which is how area grows along a ray. Otherwise the same.
[[nodiscard]] const Gauss_rule& radial_rule(int size);

}  // namespace annulus::inline v1
