// SPDX-License-Identifier: GPL-3.0-or-later
// How often the hull winds in 3D, read off its silhouette (docs/theory.md 1.2, (c)).
#include <annulus/mesh/border.h>

#include <annulus/mesh/certificates.h>
#include <annulus/predicate/exact_sign.h>
#include <annulus/predicate/orientation_sign.h>

#include <unordered_map>

namespace annulus::inline v1 {

namespace {

/// The first nonzero sign among the components z, y, x of (b - a) x (c - a): how a b c turns seen from (e^2, e, 1).
/// Each component is an orientation in a coordinate plane.
int turn(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c) {
    for (const auto& [i, j] : {std::pair{0U, 1U}, {2U, 0U}, {1U, 2U}}) {
        const Coordinates<2> p{a[i], a[j]};
        const Coordinates<2> q{b[i], b[j]};
        const Coordinates<2> r{c[i], c[j]};
        const Tuple<2, 3> points{&p, &q, &r};
        if (const int clear = orientation_sign(points); clear != 0) return clear;
        if (const int sign = exact_orientation_sign(points).sign; sign != 0) return sign;
    }
    return 0;
}

/// The direction from a to b is in the upper half-plane, seen from there.
bool points_up(const Coordinates<3>& a, const Coordinates<3>& b) {
    if (a[1] != b[1]) return a[1] < b[1];
    if (a[2] != b[2]) return a[2] > b[2];
    return a[0] < b[0];
}

/// v is strictly between u and w, all three on one line.
bool between(const Coordinates<3>& u, const Coordinates<3>& v, const Coordinates<3>& w) {
    return (u < v && v < w) || (w < v && v < u);  // lexicographic order is the order along any line
}

}  // namespace

/// The silhouette seen from (e^2, e, 1) consists of the edges between a border facet that faces the viewer and one
/// that faces away. The border, convex at its ridges, winds once if the silhouette is one closed polygon that turns
/// left and winds once.
bool border_winds_once(const Corner_table<3>& t, std::span<const Coordinates<3>> positions, std::size_t& seen) {
    const auto x = [&](Index v) -> const Coordinates<3>& { return positions[static_cast<std::size_t>(v)]; };
    std::vector<Corner_index> outer;  // half-facets at infinity
    enum : char { not_met, away, viewer };
    By_cell<char> faces(t.cell_bound().offset(), not_met);  // the facet of an infinite cell
    const auto enter = [&](Cell_index c) {
        if (faces[c] != not_met) return;
        const Corner_index h = t.corner(c, t.slot_of_infinity(c));
        const auto f = facet_and_vertex(t, h);  // seen from outside it turns left
        outer.push_back(h);
        faces[c] = turn(x(f[0].vertex), x(f[1].vertex), x(f[2].vertex)) > 0 ? viewer : away;
    };
    enter(t.cell_of(t.corner_of_infinity()));
    for (std::size_t k = 0; k < outer.size(); ++k)
        for (int i = 0; i <= 3; ++i)
            if (const Corner_index h = t.corner(t.cell_of(outer[k]), i); h != outer[k]) enter(t.cell_of(t.twin(h)));
    seen += outer.size();
    std::unordered_map<Index, Index> next;
    for (const Corner_index h : outer) {
        const Cell_index c = t.cell_of(h);
        if (faces[c] == away) continue;
        const auto f = facet_and_vertex(t, h);
        for (std::size_t i = 0; i < 3; ++i) {
            const Cell_index beyond = t.cell_of(t.twin(t.corner(c, t.slot(c, f[i]))));
            if (faces[beyond] == viewer) continue;
            if (!next.emplace(f[(i + 1) % 3].vertex, f[(i + 2) % 3].vertex).second) return false;
        }
    }
    int entries = 0;
    for (const auto& [u, v] : next) {
        const auto after = next.find(v);
        if (after == next.end()) return false;
        const Index w = after->second;
        const int left = turn(x(u), x(v), x(w));
        if (left < 0 || (left == 0 && !between(x(u), x(v), x(w)))) return false;
        if (!points_up(x(u), x(v)) && points_up(x(v), x(w))) ++entries;
    }
    return entries == 1;
}

}  // namespace annulus::inline v1
