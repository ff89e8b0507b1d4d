// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/facet_side.h>
#include <apps/motion/cells_3.h>
#include <apps/motion/tetrahedral_faults.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <numeric>
#include <utility>

namespace annulus::inline v1 {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

struct Cell_facet {
    Facet_side<3> side;
    std::size_t cell, opposite;
};

/// The facets of all cells, equal ones next to each other, in the order of their cells.
std::vector<Cell_facet> sorted_facets(const std::vector<std::array<Index, 4>>& cells) {
    std::vector<Cell_facet> facets;
    facets.reserve(4 * cells.size());
    for (std::size_t c = 0; c < cells.size(); ++c)
        for (std::size_t i = 0; i < 4; ++i) facets.push_back({{sites_of<3>(cells[c]), static_cast<int>(i)}, c, i});
    std::sort(facets.begin(), facets.end(), [](const Cell_facet& f, const Cell_facet& g) {
        return f.side.sites != g.side.sites ? f.side.sites < g.side.sites : f.cell < g.cell;
    });
    return facets;
}

}  // namespace

std::optional<Cell_fault> cell_fault(std::span<const Coordinates<3>> points, std::vector<std::array<Index, 4>>& cells) {
    const auto point = [&](Index i) {
        const auto& p = points[static_cast<std::size_t>(i)];
        return Point(p[0], p[1], p[2]);
    };
    std::optional<std::size_t> positive, negative;
    for (std::size_t c = 0; c < cells.size(); ++c) {
        const auto& v = cells[c];
        const CGAL::Orientation sign = CGAL::orientation(point(v[0]), point(v[1]), point(v[2]), point(v[3]));
        if (sign == CGAL::ZERO) return Cell_fault{Cell_fault::Kind::flat, c, c};
        auto& first = sign == CGAL::POSITIVE ? positive : negative;
        if (!first) first = c;
        if (positive && negative) return Cell_fault{Cell_fault::Kind::inverted, *negative, *positive};
    }
    if (negative)
        for (auto& c : cells) std::swap(c[2], c[3]);
    const std::vector<Cell_facet> facets = sorted_facets(cells);
    for (std::size_t i = 1; i < facets.size(); ++i) {
        if (facets[i].side.sites != facets[i - 1].side.sites) continue;
        if (i > 1 && facets[i].side.sites == facets[i - 2].side.sites)
            return Cell_fault{Cell_fault::Kind::crowded, facets[i].cell, facets[i - 2].cell};
        const bool third = i + 1 < facets.size() && facets[i].side.sites == facets[i + 1].side.sites;
        if (!third && facets[i].side.left == facets[i - 1].side.left)
            return Cell_fault{Cell_fault::Kind::folded, facets[i].cell, facets[i - 1].cell};
    }
    return std::nullopt;
}

Boundary_facets boundary_facets(const std::vector<std::array<Index, 4>>& cells) {
    const std::vector<Cell_facet> facets = sorted_facets(cells);
    std::vector<std::array<std::size_t, 2>> alone;  // cell, corner opposite
    for (std::size_t i = 0; i < facets.size(); ++i) {
        const bool before = i > 0 && facets[i - 1].side.sites == facets[i].side.sites;
        const bool after = i + 1 < facets.size() && facets[i + 1].side.sites == facets[i].side.sites;
        if (!before && !after) alone.push_back({facets[i].cell, facets[i].opposite});
    }
    std::sort(alone.begin(), alone.end());
    Boundary_facets result;
    for (const auto& [c, i] : alone) {
        const auto& corner = facet_corners[i];
        result.triangles.push_back({cells[c][corner[0]], cells[c][corner[1]], cells[c][corner[2]]});
        result.cells.push_back(c);
    }
    return result;
}

std::optional<std::size_t> covered_twice(const Domain_3& domain, std::span<const Coordinates<3>> points,
                                         const std::vector<std::array<Index, 4>>& cells,
                                         const Boundary_facets& facets) {
    // The parts of the boundary, each by one of its vertices.
    std::vector<Index> parent(points.size());
    std::iota(parent.begin(), parent.end(), Index{0});
    const auto root = [&parent](Index v) {
        while (parent[static_cast<std::size_t>(v)] != v)
            v = parent[static_cast<std::size_t>(v)] =
                parent[static_cast<std::size_t>(parent[static_cast<std::size_t>(v)])];
        return v;
    };
    for (const auto& t : facets.triangles)
        for (const Index v : {t[1], t[2]}) parent[static_cast<std::size_t>(root(v))] = root(t[0]);
    // The largest cell of each is tested: rounding cannot put its centroid outside.
    struct Largest {
        double volume = -1;
        std::size_t cell = 0;
    };
    std::vector<Largest> largest(points.size());
    const auto corner = [&](std::size_t c, std::size_t i) { return points[static_cast<std::size_t>(cells[c][i])]; };
    for (std::size_t t = 0; t < facets.triangles.size(); ++t) {
        const std::size_t c = facets.cells[t];
        const double volume = cell_moment(corner(c, 0), corner(c, 1), corner(c, 2), corner(c, 3)).volume;
        Largest& here = largest[static_cast<std::size_t>(root(facets.triangles[t][0]))];
        if (volume > here.volume) here = {volume, c};
    }
    for (const Largest& l : largest) {
        if (l.volume < 0) continue;
        Coordinates<3> middle{};
        for (std::size_t i = 0; i < 4; ++i)
            for (std::size_t k = 0; k < 3; ++k) middle[k] += corner(l.cell, i)[k] / 4;
        if (!domain.contains(middle)) return l.cell;
    }
    return std::nullopt;
}

}  // namespace annulus::inline v1
