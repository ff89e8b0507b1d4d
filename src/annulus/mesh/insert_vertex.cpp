// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/mesh/insert_vertex.h>

#include <annulus/certificate/circumcircle_2.h>
#include <annulus/certificate/circumsphere_3.h>
#include <annulus/mesh/degenerate.h>
#include <annulus/mesh/replace_cells.h>
#include <annulus/mesh/small_set.h>
#include <annulus/mesh/walk.h>

namespace annulus {

namespace {

Circumcircle_2 sphere_of(const Tuple<2, 3>& x) { return {*x[0], *x[1], *x[2]}; }
Circumsphere_3 sphere_of(const Tuple<3, 4>& x) { return {*x[0], *x[1], *x[2], *x[3]}; }

template <int d>
class Conflicts {
  public:
    Conflicts(const Cell_table<d>& t, std::span<const Coordinates<d>> x, Index v)
        : t_(t), x_(x), p_(x[static_cast<std::size_t>(v)]) {}

    /// The sphere of a cell holds p. That of a cell with infinity is the half-space beyond its facet and, in the plane
    /// of the facet, the circle that its finite neighbour cuts there.
    [[nodiscard]] bool operator()(Cell_index c) const {
        const int i = t_.slot_of_infinity(c);
        if (i < 0) return sphere_holds(c);
        Cell_sites<d> v = cell_sites(t_, c);
        v[static_cast<std::size_t>(i)] = v[i == 0 ? 1U : 0U];  // somebody's place, for the tuple to be one
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

    const Cell_table<d>& t_;
    std::span<const Coordinates<d>> x_;
    const Coordinates<d>& p_;
};

}  // namespace

template <int d>
void insert_vertex(Cell_table<d>& t, std::span<const Coordinates<d>> x, Cell_index first, Index v,
                   std::vector<Cell_index>& changed) {
    const Conflicts<d> conflicts(t, x, v);
    std::vector<Cell_index> region{first};
    std::vector<Cell_sites<d>> fresh;
    Small_set<Cell_index, Index_hash> inside(no_cell);
    Small_set<Cell_index, Index_hash> outside(no_cell);
    inside.insert(first);
    for (std::size_t k = 0; k < region.size(); ++k)
        for (int i = 0; i <= d; ++i) {
            const Cell_index n = t.cell_of(t.twin(t.corner(region[k], i)));
            if (inside.contains(n)) continue;
            if (!outside.contains(n) && conflicts(n)) {
                inside.insert(n);
                region.push_back(n);
                continue;
            }
            outside.insert(n);
            Cell_sites<d>& cell = fresh.emplace_back(cell_sites(t, region[k]));
            cell[static_cast<std::size_t>(i)] = Site<d>(v);
        }
    replace_cells<d>(t, region, fresh, changed);
}

template void insert_vertex<2>(Cell_table<2>&, std::span<const Coordinates<2>>, Cell_index, Index,
                               std::vector<Cell_index>&);
template void insert_vertex<3>(Cell_table<3>&, std::span<const Coordinates<3>>, Cell_index, Index,
                               std::vector<Cell_index>&);

}  // namespace annulus
