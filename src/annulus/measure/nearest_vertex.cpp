// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/nearest_vertex.h>

#include <annulus/arithmetic/exact.h>
#include <annulus/predicate/bounds.h>

#include <array>
#include <cmath>

namespace annulus::inline v1 {

/// |q - b|^2 - |q - a|^2 = (a - b) . ((q - a) + (q - b)) is positive. Each factor
/// of a term has three roundings at most, of numbers that are below the sum of magnitudes which stands in the bound.
template <int d>
bool is_nearer(const Coordinates<d>& q, const Coordinates<d>& a, const Coordinates<d>& b) {
    double sum = 0;
    double size = 0;
    for (std::size_t k = 0; k < d; ++k) {
        const double edge = a[k] - b[k];
        const double to_a = q[k] - a[k];
        const double to_b = q[k] - b[k];
        sum += edge * (to_a + to_b);
        size += std::fabs(edge) * (std::fabs(to_a) + std::fabs(to_b));
    }
    const double error = 16 * bounds::u * size + 0x1p-1060;
    if (std::fabs(sum) > error) return sum > 0;
    std::array<double, static_cast<std::size_t>(3 * d)> numbers;
    for (std::size_t k = 0; k < d; ++k) {
        numbers[k] = q[k];
        numbers[d + k] = a[k];
        numbers[2 * d + k] = b[k];
    }
    const Scaled_integers exactly(numbers);
    mpz_class total = 0;
    for (std::size_t k = 0; k < d; ++k) {
        const mpz_class& at_q = exactly.integer[k];
        const mpz_class& at_a = exactly.integer[d + k];
        const mpz_class& at_b = exactly.integer[2 * d + k];
        total += (at_a - at_b) * (2 * at_q - at_a - at_b);
    }
    return sgn(total) > 0;
}

template <int d>
void nearest_vertices(std::span<const Coordinates<d>> points, const Vertex_neighbours& neighbours, Index first,
                      std::span<const Coordinates<d>> queries, std::span<Index> found) {
    const auto place = [&points](Index v) -> const Coordinates<d>& { return points[static_cast<std::size_t>(v)]; };
    Index last = first;
    for (std::size_t i = 0; i < queries.size(); ++i) {
        Index here = found[i] < 0 ? last : found[i];
        for (bool arrived = false; !arrived;) {
            arrived = true;
            for (const Index n : neighbours.of(here))
                if (is_nearer<d>(queries[i], place(n), place(here))) {
                    here = n;
                    arrived = false;
                    break;
                }
        }
        last = found[i] = here;
    }
}

template bool is_nearer<2>(const Coordinates<2>&, const Coordinates<2>&, const Coordinates<2>&);
template bool is_nearer<3>(const Coordinates<3>&, const Coordinates<3>&, const Coordinates<3>&);
template void nearest_vertices<2>(std::span<const Coordinates<2>>, const Vertex_neighbours&, Index,
                                  std::span<const Coordinates<2>>, std::span<Index>);
template void nearest_vertices<3>(std::span<const Coordinates<3>>, const Vertex_neighbours&, Index,
                                  std::span<const Coordinates<3>>, std::span<Index>);

}  // namespace annulus::inline v1
