// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/voronoi.h>

#include <annulus/measure/voronoi_facets.h>
#include <annulus/measure/voronoi_input.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace annulus::inline v1 {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// Visits the facets that contribute, with A / |x_i - x_j| times (c - x_i) and (c - x_j), where c is the centroid of
/// the facet and A its measure, in the unit 2^exponent to the power of d - 1.
template <int d, class Visit>
void for_each_term(Voronoi_facets<d>& facets, Visit visit) {
    const int exponent = facets.exponent();
    const double scale = std::ldexp(1.0, -exponent);
    facets.for_each([&](const Voronoi_facet<d>& f) {
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

}  // namespace

template <int d>
std::vector<Coordinates<d>> voronoi_gradient(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                             std::span<const double> weights) {
    require_weights(weights.size(), points.size());
    Voronoi_facets<d> facets(points, cells);
    std::vector<Coordinates<d>> gradient(points.size());
    const auto& where = facets.input().where;
    const auto weight = [&](Index v) { return where[at(v)] == Vertex_location::inside ? weights[at(v)] : 0.0; };
    for_each_term<d>(facets,
                     [&](const Voronoi_facet<d>& f, const Coordinates<d>& from_i, const Coordinates<d>& from_j) {
                         const double difference = weight(f.i) - weight(f.j);
                         if (f.empty || !f.bounded) return;
                         for (std::size_t k = 0; k < d; ++k) {
                             gradient[at(f.i)][k] += difference * from_i[k];
                             gradient[at(f.j)][k] -= difference * from_j[k];
                         }
                     });
    scale_back<d>(gradient, facets.exponent());
    return gradient;
}

template <int d>
Voronoi_jacobian<d> voronoi_jacobian(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells) {
    struct Entry {
        Index row, column;
        Coordinates<d> value;
    };
    Voronoi_facets<d> facets(points, cells);
    const auto& where = facets.input().where;
    const auto is_row = [&where](Index v) { return where[at(v)] == Vertex_location::inside; };
    std::vector<Entry> entries;
    std::vector<Coordinates<d>> diagonal(points.size());
    Voronoi_jacobian<d> out;
    out.begin.assign(points.size() + 1, 0);
    const auto add = [&](Index row, Index column, const Coordinates<d>& from_row, const Coordinates<d>& from_column) {
        if (!is_row(row)) return;
        Entry entry{row, column, {}};
        for (std::size_t k = 0; k < d; ++k) {
            diagonal[at(row)][k] += from_row[k];
            entry.value[k] = -from_column[k];
        }
        entries.push_back(entry);
        ++out.begin[at(row) + 1];
    };
    for_each_term<d>(facets,
                     [&](const Voronoi_facet<d>& f, const Coordinates<d>& from_i, const Coordinates<d>& from_j) {
                         add(f.i, f.j, from_i, from_j);
                         add(f.j, f.i, from_j, from_i);
                     });
    for (std::size_t v = 0; v < points.size(); ++v)
        if (is_row(static_cast<Index>(v))) {
            entries.push_back({static_cast<Index>(v), static_cast<Index>(v), diagonal[v]});
            ++out.begin[v + 1];
        }
    std::partial_sum(out.begin.begin(), out.begin.end(), out.begin.begin());
    std::vector<Index> end(out.begin.begin(), out.begin.end() - 1);
    std::vector<const Entry*> sorted(entries.size());
    for (const Entry& e : entries) sorted[at(end[at(e.row)]++)] = &e;
    for (std::size_t v = 0; v < points.size(); ++v)
        std::sort(sorted.begin() + out.begin[v], sorted.begin() + out.begin[v + 1],
                  [](const Entry* a, const Entry* b) { return a->column < b->column; });
    out.index.reserve(sorted.size());
    out.value.reserve(sorted.size());
    for (const Entry* e : sorted) {
        out.index.push_back(e->column);
        out.value.push_back(e->value);
    }
    scale_back<d>(out.value, facets.exponent());
    return out;
}

template std::vector<Coordinates<2>> voronoi_gradient<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&,
                                                         std::span<const double>);
template std::vector<Coordinates<3>> voronoi_gradient<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&,
                                                         std::span<const double>);
template Voronoi_jacobian<2> voronoi_jacobian<2>(std::span<const Coordinates<2>>, const Mesh_cells<2>&);
template Voronoi_jacobian<3> voronoi_jacobian<3>(std::span<const Coordinates<3>>, const Mesh_cells<3>&);

}  // namespace annulus::inline v1
