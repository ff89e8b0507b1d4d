// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/insert_vertex.h>

#include <annulus/mesh/degenerate.h>
#include <annulus/mesh/replace_cells.h>
#include <annulus/mesh/site_hash.h>
#include <annulus/mesh/small_set.h>
#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>
#include <annulus/predicate/sure_orientation.h>

#include <array>
#include <cassert>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

namespace {

Circumcircle_2 sphere_of(const Tuple<2, 3>& x) { return {*x[0], *x[1], *x[2]}; }
Circumsphere_3 sphere_of(const Tuple<3, 4>& x) { return {*x[0], *x[1], *x[2], *x[3]}; }

template <int d>
class Conflicts {
  public:
    Conflicts(const Corner_table<d>& t, std::span<const Coordinates<d>> x, Index v)
        : t_(t), x_(x), p_(x[static_cast<std::size_t>(v)]) {}

    /// Whether the sphere of a cell holds p. The sphere of an infinite cell is the half-space beyond its facet and, in
    /// the plane of the facet, the disc that the sphere of its finite neighbour cuts out.
    [[nodiscard]] bool operator()(Cell_index c) const {
        const int i = t_.slot_of_infinity(c);
        if (i < 0) return sphere_holds(c);
        Cell_sites<d> v = cell_sites(t_, c);
        v[static_cast<std::size_t>(i)] = v[i == 0 ? 1U : 0U];  // any position, so that the tuple is complete
        Tuple<d, d + 1> x = tuple<d, d + 1>(v, x_);
        x[static_cast<std::size_t>(i)] = &p_;
        const int side = sure_orientation<d>(x);
        return side != 0 ? side > 0 : sphere_holds(t_.cell_of(t_.twin(t_.corner(c, i))));
    }

  private:
    [[nodiscard]] bool sphere_holds(Cell_index c) const {
        const Tuple<d, d + 1> cell = tuple<d, d + 1>(cell_sites(t_, c), x_);
        const auto sphere = sphere_of(cell);
        if (sphere.positive()) {
            if (sphere.excludes(p_)) return false;
            if (sphere.contains(p_)) return true;
        }
        return sphere_holds_exactly<d>(cell, p_);
    }

    const Corner_table<d>& t_;
    std::span<const Coordinates<d>> x_;
    const Coordinates<d>& p_;
};

/// Finds neighbours among the cells {v, facet of the border}: two of them share a facet if their border facets share a
/// ridge of d - 1 corners. (kernel/cavity_edges.h does this for numbers of vertices in the order of a border.)
template <int d>
class Ridge_pairs {
  public:
    explicit Ridge_pairs(std::size_t facets) {
        std::size_t places = 16;
        while (places < 2 * static_cast<std::size_t>(d) * facets) places *= 2;
        place_.assign(places, 0);
        ridges_.reserve(static_cast<std::size_t>(d) * facets);
    }
    /// `half` is 4 * cell + slot of the facet of the new cell that contains v and the ridge. The ridge consists of the
    /// cell's corners without corner `i` and that slot. Returns the other half of the ridge, or nothing for the first
    /// one.
    [[nodiscard]] std::optional<std::uint32_t> pair(const Cell_sites<d>& cell, std::size_t i, std::uint32_t half) {
        Ridge r{{}, half};
        for (std::size_t k = 0, n = 0; k <= d; ++k)
            if (k != i && k != half % 4) r.sites[n++] = cell[k];
        if constexpr (d == 3)
            if (r.sites[1] < r.sites[0]) std::swap(r.sites[0], r.sites[1]);
        for (std::size_t p = first_place(r.sites, place_.size());; ++p) {
            std::uint32_t& place = place_[p & (place_.size() - 1)];
            if (place == 0) {
                ridges_.push_back(r);
                place = static_cast<std::uint32_t>(ridges_.size());
                return {};
            }
            if (ridges_[place - 1].sites == r.sites) {
                ++pairs_;
                return ridges_[place - 1].half;
            }
        }
    }

    /// Whether the border is that of a ball: each ridge is in two of its facets.
    [[nodiscard]] bool all_paired() const { return pairs_ == ridges_.size(); }

  private:
    struct Ridge {
        std::array<Site<d>, static_cast<std::size_t>(d - 1)> sites;
        std::uint32_t half;
    };
    std::vector<Ridge> ridges_;
    std::size_t pairs_ = 0;
    std::vector<std::uint32_t> place_;  // hash table of indices from 1, size a power of two; 0: empty
};

}  // namespace

template <int d>
void insert_vertex(Corner_table<d>& t, std::span<const Coordinates<d>> x, Cell_index first, Index v,
                   std::vector<Cell_index>& changed) {
    const Conflicts<d> conflicts(t, x, v);
    std::vector<Cell_index> region{first};
    std::vector<Cell_sites<d>> fresh;
    std::vector<std::pair<std::size_t, Corner_index>> border;  // the slot of v in each of these, and what is beyond
    Small_set<Cell_index, Index_hash> inside(no_cell);
    Small_set<Cell_index, Index_hash> outside(no_cell);
    inside.insert(first);
    for (std::size_t k = 0; k < region.size(); ++k)
        for (int i = 0; i <= d; ++i) {
            const Corner_index twin = t.twin(t.corner(region[k], i));
            const Cell_index n = t.cell_of(twin);
            if (inside.contains(n)) continue;
            if (!outside.contains(n) && conflicts(n)) {
                inside.insert(n);
                region.push_back(n);
                continue;
            }
            outside.insert(n);
            Cell_sites<d>& cell = fresh.emplace_back(cell_sites(t, region[k]));
            cell[static_cast<std::size_t>(i)] = Site<d>(v);
            border.emplace_back(static_cast<std::size_t>(i), twin);
        }
    std::vector<Fresh_neighbours<d>> neighbours(fresh.size());
    Ridge_pairs<d> ridges(fresh.size());
    for (std::size_t k = 0; k < fresh.size(); ++k) {
        const auto [own, beyond] = border[k];
        neighbours[k][own].beyond = beyond;
        for (std::size_t j = 0; j <= d; ++j) {
            if (j == own) continue;
            const auto half = static_cast<std::uint32_t>(4 * k + j);
            if (const auto other = ridges.pair(fresh[k], own, half)) {
                neighbours[k][j].fresh = *other;
                neighbours[*other / 4][*other % 4].fresh = half;
            }
        }
    }
    assert(ridges.all_paired());
    replace_cells<d>(t, region, fresh, neighbours, changed);
}

template void insert_vertex<2>(Corner_table<2>&, std::span<const Coordinates<2>>, Cell_index, Index,
                               std::vector<Cell_index>&);
template void insert_vertex<3>(Corner_table<3>&, std::span<const Coordinates<3>>, Cell_index, Index,
                               std::vector<Cell_index>&);

}  // namespace annulus::inline v1
