// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/periodic_nearest.h>

#include <annulus/measure/nearest_vertex.h>
#include <annulus/mesh/small_set.h>
#include <annulus/space/for_each_shift.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace annulus::inline v1 {

namespace {

/// Walks to the nearest image.
template <int d>
class Nearest_walk {
  public:
    Nearest_walk(const Periodic_table<d>& table, const Lattice<d>& lattice, std::span<const Coordinates<d>> place,
                 const Coordinates<d>& p)
        : table_(table), lattice_(lattice), place_(place), p_(p) {}

    /// Nothing where it goes too far.
    [[nodiscard]] std::optional<Lifted_corner<d>> from(Lifted_cell<d> start) {
        Lifted_corner<d> here{start, 0};
        Coordinates<d> best = at(start, 0);
        for (std::size_t i = 1; i <= d; ++i) {
            const Coordinates<d> x = at(start, i);
            if (!is_nearer<d>(p_, x, best)) continue;
            here.slot = i;
            best = x;
        }
        for (;;) {
            const Image<d> image = table_.image(here.at.cell, here.slot, here.at.shift);
            if (!has_exact_neighbours(image.label)) return {};
            const auto nearer = neighbour_nearer_than(here, best);
            if (!nearer) return here;
            here = *nearer;
            best = at(here.at, here.slot);
        }
    }

  private:
    /// Edges have coordinates below 3 in the basis, and places with offsets up to 8 are exact.
    [[nodiscard]] static bool has_exact_neighbours(Offset<d> o) {
        constexpr std::int32_t most = 4;
        for (const std::int32_t c : o.unpacked())
            if (c < -most || c > most) return false;
        return true;
    }
    [[nodiscard]] Coordinates<d> at(Lifted_cell<d> c, std::size_t i) const {
        const Image<d> s = table_.image(c.cell, i, c.shift);
        return lattice_.place(place_[static_cast<std::size_t>(s.vertex)], s.label);
    }
    /// Walks around a vertex until a neighbour is nearer to p than the vertex, which is at x.
    [[nodiscard]] std::optional<Lifted_corner<d>> neighbour_nearer_than(const Lifted_corner<d>& v,
                                                                        const Coordinates<d>& x) {
        const Image<d> image = table_.image(v.at.cell, v.slot, v.at.shift);
        Small_set<Corner_index, Index_hash> met(no_corner);  // around one image each corner of the vertex occurs once
        star_.assign(1, v);
        met.insert(table_.corner(v.at.cell, v.slot));
        for (std::size_t k = 0; k < star_.size(); ++k) {
            const Lifted_corner<d> here = star_[k];
            for (std::size_t i = 0; i <= d; ++i) {
                if (i == here.slot) continue;
                if (is_nearer<d>(p_, at(here.at, i), x)) return Lifted_corner<d>{here.at, i};
                const Lifted_cell<d> next = beyond(table_, here.at, i);
                const std::size_t slot = table_.slot(next.cell, image, next.shift);
                if (met.insert(table_.corner(next.cell, slot))) star_.push_back({next, slot});
            }
        }
        return {};
    }

    const Periodic_table<d>& table_;
    const Lattice<d>& lattice_;
    std::span<const Coordinates<d>> place_;
    Coordinates<d> p_;
    std::vector<Lifted_corner<d>> star_;
};

}  // namespace

template <int d>
Lifted_corner<d> nearest_corner(const Periodic_table<d>& table, const Lattice<d>& lattice,
                                std::span<const Coordinates<d>> place, const Coordinates<d>& p, Lifted_cell<d> start) {
    const auto found = Nearest_walk<d>(table, lattice, place, p).from(start);
    return found ? *found : corner_at<d>(table, nearest_of_all<d>(lattice, place, p));
}

template <int d>
Lifted_corner<d> corner_at(const Periodic_table<d>& table, Image<d> image) {
    Lifted_corner<d> found{{0, {}}, 0};
    while (table.vertex[found.at.cell][found.slot] != image.vertex)
        if (++found.slot > d) found = {{found.at.cell + 1, {}}, 0};
    found.at.shift = image.label - table.offset[found.at.cell][found.slot];
    return found;
}

/// Of one vertex the nearest image is in the Voronoi cell of the lattice around p, so that its coordinates in the basis
/// are within half the reach, 1.25, of those of p.
template <int d>
Image<d> nearest_of_all(const Lattice<d>& lattice, std::span<const Coordinates<d>> place, const Coordinates<d>& p) {
    Image<d> nearest(none);
    Coordinates<d> best{};
    for (std::size_t v = 0; v < place.size(); ++v) {
        if (!is_place<d>(place[v])) continue;
        Coordinates<d> way;
        for (std::size_t i = 0; i < d; ++i) way[i] = p[i] - place[v][i];
        way = lattice.in_basis(way);
        Shift<d> near;
        for (std::size_t i = 0; i < d; ++i) near[i] = static_cast<std::int32_t>(std::nearbyint(way[i]));
        for_each_shift<d>(2, [&](const Shift<d>& o) {
            const Offset<d> offset = Offset<d>(near) + Offset<d>(o);
            const Coordinates<d> x = lattice.place(place[v], offset);
            if (nearest.vertex == none || is_nearer<d>(p, x, best)) {
                nearest = Image<d>(static_cast<Index>(v), offset);
                best = x;
            }
        });
    }
    return nearest;
}

template Lifted_corner<2> nearest_corner(const Periodic_table<2>&, const Lattice<2>&, std::span<const Coordinates<2>>,
                                         const Coordinates<2>&, Lifted_cell<2>);
template Lifted_corner<3> nearest_corner(const Periodic_table<3>&, const Lattice<3>&, std::span<const Coordinates<3>>,
                                         const Coordinates<3>&, Lifted_cell<3>);
template Lifted_corner<2> corner_at(const Periodic_table<2>&, Image<2>);
template Lifted_corner<3> corner_at(const Periodic_table<3>&, Image<3>);
template Image<2> nearest_of_all(const Lattice<2>&, std::span<const Coordinates<2>>, const Coordinates<2>&);
template Image<3> nearest_of_all(const Lattice<3>&, std::span<const Coordinates<3>>, const Coordinates<3>&);

}  // namespace annulus::inline v1
