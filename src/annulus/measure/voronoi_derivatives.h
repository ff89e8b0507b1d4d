// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <annulus/voronoi.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

// Derivatives of Voronoi volumes from facets, which are Voronoi_facets or Periodic_facets: for_each(visit) visits each
// once, and exponent() is that of the unit of most.
namespace annulus::inline v1 {

/// Visits the facets that contribute, with A / |x_i - x_j| times (c - x_i) and (c - x_j), where c is the centroid of
/// the facet and A its measure, in the unit 2^exponent to the power of d - 1; zeros for the others. Facets between
/// images of one vertex are not visited: they move with both, and what one side loses the other gains.
template <int d, class Facets, class Visit>
void for_each_derivative(Facets& facets, Visit visit) {
    const int exponent = facets.exponent();
    const double scale = std::ldexp(1.0, -exponent);
    facets.for_each([&](const auto& f) {
        if (f.i == f.j) return;
        Coordinates<d> from_i{};
        Coordinates<d> from_j{};
        if (f.bounded && !f.empty) {
            const bool usual = f.exponent == exponent;
            const double to_unit = usual ? scale : std::ldexp(1.0, std::clamp(-f.exponent, -1022, 1022));
            const double ratio = static_cast<double>(f.measure) / (f.distance * to_unit);
            const double change =
                usual ? 1 : std::ldexp(1.0, std::clamp((f.exponent - exponent) * (d - 1), -2000, 2000));
            for (std::size_t k = 0; k < d; ++k) {
                from_i[k] = ratio * f.centroid[k] * change;
                from_j[k] = ratio * (f.centroid[k] - f.vector[k] * to_unit) * change;
            }
        }
        visit(f, from_i, from_j);
    });
}

template <int d>
void scale_back(std::vector<Coordinates<d>>& vectors, int exponent) {
    for (auto& v : vectors)
        for (double& c : v) c = std::ldexp(c, exponent * (d - 1));
}

/// The gradient of the sum of weight(v) times the volume of v, over n vertices.
template <int d, class Facets, class Weight>
[[nodiscard]] std::vector<Coordinates<d>> gradient_of_volumes(Facets& facets, std::size_t n, Weight weight) {
    std::vector<Coordinates<d>> gradient(n);
    for_each_derivative<d>(facets, [&](const auto& f, const Coordinates<d>& from_i, const Coordinates<d>& from_j) {
        const double difference = weight(f.i) - weight(f.j);
        if (f.empty || !f.bounded) return;
        for (std::size_t k = 0; k < d; ++k) {
            gradient[static_cast<std::size_t>(f.i)][k] += difference * from_i[k];
            gradient[static_cast<std::size_t>(f.j)][k] -= difference * from_j[k];
        }
    });
    scale_back<d>(gradient, facets.exponent());
    return gradient;
}

/// All derivatives over n vertices. There is a row for v if is_row(v). Neighbours that share several facets have one
/// entry, the sum.
template <int d, class Facets, class Is_row>
[[nodiscard]] Voronoi_jacobian<d> jacobian_of_volumes(Facets& facets, std::size_t n, Is_row is_row) {
    struct Entry {
        Index row, column;
        Coordinates<d> value;
    };
    const auto at = [](Index i) { return static_cast<std::size_t>(i); };
    std::vector<Entry> entries;
    std::vector<Coordinates<d>> diagonal(n);
    std::vector<std::size_t> begin(n + 1, 0);
    const auto add = [&](Index row, Index column, const Coordinates<d>& from_row, const Coordinates<d>& from_column) {
        if (!is_row(row)) return;
        Entry entry{row, column, {}};
        for (std::size_t k = 0; k < d; ++k) {
            diagonal[at(row)][k] += from_row[k];
            entry.value[k] = -from_column[k];
        }
        entries.push_back(entry);
        ++begin[at(row) + 1];
    };
    for_each_derivative<d>(facets, [&](const auto& f, const Coordinates<d>& from_i, const Coordinates<d>& from_j) {
        add(f.i, f.j, from_i, from_j);
        add(f.j, f.i, from_j, from_i);
    });
    for (std::size_t v = 0; v < n; ++v)
        if (is_row(static_cast<Index>(v))) {
            entries.push_back({static_cast<Index>(v), static_cast<Index>(v), diagonal[v]});
            ++begin[v + 1];
        }
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<std::size_t> end(begin.begin(), begin.end() - 1);
    std::vector<const Entry*> sorted(entries.size());
    for (const Entry& e : entries) sorted[end[at(e.row)]++] = &e;
    Voronoi_jacobian<d> out;
    out.begin.assign(n + 1, 0);
    out.index.reserve(sorted.size());
    out.value.reserve(sorted.size());
    for (std::size_t v = 0; v < n; ++v) {
        const auto first = sorted.begin() + static_cast<std::ptrdiff_t>(begin[v]);
        const auto last = sorted.begin() + static_cast<std::ptrdiff_t>(begin[v + 1]);
        std::stable_sort(first, last, [](const Entry* a, const Entry* b) { return a->column < b->column; });
        for (auto e = first; e != last; ++e) {
            if (e != first && (*e)->column == out.index.back()) {
                for (std::size_t k = 0; k < d; ++k) out.value.back()[k] += (*e)->value[k];
                continue;
            }
            out.index.push_back((*e)->column);
            out.value.push_back((*e)->value);
        }
        out.begin[v + 1] = static_cast<Index>(out.index.size());
    }
    scale_back<d>(out.value, facets.exponent());
    return out;
}

}  // namespace annulus::inline v1
