// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_facets.h>

#include <annulus/arithmetic/environment.h>
#include <annulus/error.h>

#include <algorithm>
#include <string>

namespace annulus::inline v1 {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

}  // namespace

template <int d>
Voronoi_facets<d>::Voronoi_facets(std::span<const Coordinates<d>> points, const Mesh_cells<d>& cells,
                                  const Known_circumcentres<d>* known)
    : input_((require_sound_environment(), points), cells),
      exponent_(std::max(input_.exponent, -1000)),
      scale_(std::ldexp(1.0, -exponent_)) {
    if (!input_.spans) return;
    centre_ = known != nullptr && known->exponent == exponent_
                  ? input_.circumcentres(scale_, known->before, known->centre)
                  : input_.circumcentres(scale_);
}

/// Ascending, each once.
template <int d>
std::vector<std::array<Index, 2>> Voronoi_facets<d>::flat_edges() const {
    std::vector<std::array<Index, 2>> edges;
    for (const auto& cell : input_.cells.vertices)
        for (std::size_t a = 0; a <= d; ++a)
            for (std::size_t b = 0; b < a; ++b)
                if (cell[a] != none && cell[b] != none)
                    edges.push_back({std::min(cell[a], cell[b]), std::max(cell[a], cell[b])});
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

template <int d>
bool Voronoi_facets<d>::is_cospherical(Index c, std::size_t k) {
    if (verdict_.empty()) verdict_.assign(centre_.size() * (d + 1), Verdict::unknown);
    Verdict& verdict = verdict_[at(c) * (d + 1) + k];
    if (verdict != Verdict::unknown) return verdict == Verdict::same;
    const Index n = input_.cells.neighbours[at(c)][k];
    const auto& v = input_.cells.vertices[at(c)];
    const auto& beyond = input_.cells.neighbours[at(n)];
    const auto back = static_cast<std::size_t>(std::find(beyond.begin(), beyond.end(), c) - beyond.begin());
    if (back > d) throw Error(Error_code::bad_input, "neighbours of cell " + std::to_string(c) + " are not mutual");
    const Seen_centre<d> here = seen_from(v[0], c);
    const Seen_centre<d> there = seen_from(v[0], n);
    const double error = here.error + there.error;
    bool same = true;
    for (std::size_t a = 0; a < d; ++a)
        same = same && !(std::fabs(here.offset[a] - there.offset[a]) > (1 + 0x1p-40) * error);
    if (same) {
        Corners<d> corners;
        for (std::size_t i = 0; i <= d; ++i) corners[i] = input_.points[at(v[i])];
        same = is_on_circumsphere<d>(corners, input_.points[at(input_.cells.vertices[at(n)][back])]);
    }
    verdict = same ? Verdict::same : Verdict::different;
    verdict_[at(n) * (d + 1) + back] = verdict;
    return same;
}

template <int d>
Coordinates<d> Voronoi_facets<d>::vertex(Index c) const {
    const Coordinates<d>& base = input_.points[at(input_.cells.vertices[at(c)][0])];
    Coordinates<d> out;
    for (std::size_t k = 0; k < d; ++k) out[k] = base[k] + std::ldexp(centre_[at(c)].offset[k], exponent_);
    return out;
}

/// Whether the facets of the hull at both ends of an open ring are in one plane.
template <int d>
bool Voronoi_facets<d>::is_flat_hull(const Edge_ring& ring) const {
    if constexpr (d == 2) return false;
    else {
        const auto other = [&](Index c, Index than) {
            for (const Index v : input_.cells.vertices[at(c)])
                if (v != ring.i && v != ring.j && v != than) return v;
            return none;
        };
        const auto corner = [&](std::size_t k) {
            return input_.cells.vertices[at(ring.cells[k])][static_cast<std::size_t>(ring.crossing[k])];
        };
        const std::size_t last = ring.cells.size() - 1;
        const Index before = corner(0);  // the third corner of the facet of the hull where the ring begins
        const Index after = other(ring.cells[last], corner(last));
        const auto& x = input_.points;
        return before != none && after != none &&
               are_coplanar({x[at(ring.i)], x[at(ring.j)], x[at(before)], x[at(after)]});
    }
}

/// Fewer than d directions; those to infinity count as two, and are opposite if the facet is to have no area.
template <int d>
bool Voronoi_facets<d>::is_empty(const Edge_ring& ring) {
    if (ring.open && !is_flat_hull(ring)) return false;
    std::size_t sides = ring.open ? 2 : 0;
    const std::size_t crossed = ring.open || d == 2 ? ring.cells.size() - 1 : ring.cells.size();
    for (std::size_t k = 0; k < crossed && sides < d; ++k)
        if (!is_cospherical(ring.cells[k], static_cast<std::size_t>(ring.crossing[k]))) ++sides;
    if constexpr (d == 2) return sides == 0;
    else return sides < 3;
}

template <int d>
Voronoi_facet<d> Voronoi_facets<d>::facet_of(const Edge_ring& ring) {
    Voronoi_facet<d> facet;
    facet.i = ring.i;
    facet.j = ring.j;
    facet.ring = ring.cells;
    facet.bounded = !ring.open;
    note_edge(facet);
    if (!ring.open && measure(facet)) return facet;
    facet.empty = !ring.cells.empty() && is_empty(ring);
    if (facet.empty || ring.open) {
        facet.measure = facet.empty ? 0 : unbounded;
        facet.centroid.fill(nowhere);
        facet.exponent = 0;
        return facet;
    }
    static_cast<Facet_measure<d>&>(facet) = exact_facet<d>(input_.points, input_.cells, ring.i, ring.j, ring.cells);
    return facet;
}

template class Voronoi_facets<2>;
template class Voronoi_facets<3>;

}  // namespace annulus::inline v1
