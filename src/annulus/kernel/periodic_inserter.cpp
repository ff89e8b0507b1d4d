// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/periodic_inserter.h>

#include <annulus/arithmetic/limits.h>
#include <annulus/error.h>
#include <annulus/kernel/periodic_locate.h>
#include <annulus/mesh/degenerate.h>
#include <annulus/mesh/facet_side.h>
#include <annulus/mesh/sort_unique.h>
#include <annulus/predicate/circumcircle_2.h>
#include <annulus/predicate/circumsphere_3.h>
#include <annulus/predicate/orientation_sign.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <tuple>
#include <type_traits>

namespace annulus::inline v1 {

namespace {

template <int d>
using Places = std::array<Coordinates<d>, static_cast<std::size_t>(d + 1)>;

template <int d>
Coordinates<d> place_of(const Periodic_scene<d>& scene, Image<d> s) {
    return scene.lattice.place(scene.place[static_cast<std::size_t>(s.vertex)], s.label);
}
template <int d>
Places<d> places_of(const Periodic_scene<d>& scene, std::size_t c) {
    Places<d> x;
    for (std::size_t i = 0; i <= d; ++i) x[i] = place_of(scene, scene.table.image(c, i));
    return x;
}
template <int d>
auto sphere_of(const Places<d>& x) {
    using Sphere = std::conditional_t<d == 2, Circumcircle_2, Circumsphere_3>;
    return std::apply([](const auto&... p) { return Sphere(p...); }, x);
}
template <int d>
Tuple<d, d + 1> tuple_of(const Places<d>& x) {
    Tuple<d, d + 1> corners;
    for (std::size_t i = 0; i <= d; ++i) corners[i] = &x[i];
    return corners;
}
template <int d>
int sign_of(const Places<d>& x) {
    const Tuple<d, d + 1> corners = tuple_of<d>(x);
    const int clear = orientation_sign(corners);
    return clear != 0 ? clear : exact_orientation_sign(corners).sign;
}

/// The sphere of a cell of the table holds p, an image of a point that is no vertex.
template <int d>
bool holds(const Periodic_scene<d>& scene, std::size_t c, const Coordinates<d>& p) {
    const Places<d> x = places_of(scene, c);
    const auto sphere = sphere_of<d>(x);
    if (sphere.positive()) {
        if (sphere.excludes(p)) return false;
        if (sphere.contains(p)) return true;
    }
    return sphere_holds_exactly<d>(tuple_of<d>(x), p);
}

}  // namespace

template <int d>
void Periodic_inserter<d>::begin(const Scene& scene) {
    for (const Lifted_cell<d>& c : gone_) mark_[c.cell] = 0;  // those of the last call
    gone_.clear();
    came_.clear();
    if (mark_.size() < scene.table.size()) mark_.resize(scene.table.size() + scene.table.size() / 8, 0);
}

template <int d>
bool Periodic_inserter<d>::enter(Lifted_cell<d> c) {
    if (mark_[c.cell] != 0) return gone_[mark_[c.cell] - 1] == c;
    gone_.push_back(c);
    mark_[c.cell] = static_cast<std::uint32_t>(gone_.size());
    return true;
}

template <int d>
bool Periodic_inserter<d>::find_cavity(const Scene& scene, Lifted_cell<d> first, Index v) {
    const Coordinates<d>& p = scene.place[static_cast<std::size_t>(v)];
    if (!enter(first)) return false;
    for (std::size_t k = 0; k < gone_.size(); ++k)
        for (std::size_t i = 0; i <= d; ++i) {
            const Lifted_cell<d> g = gone_[k], m = beyond<d>(scene.table, g, i);
            if (is_entered(m)) continue;
            const Offset<d> offset = Offset<d>() - m.shift;
            if (!is_near(offset)) return false;
            if (holds(scene, m.cell, scene.lattice.place(p, offset))) {
                if (!enter(m)) return false;
                continue;
            }
            came_.push_back(scene.table.images(g.cell, g.shift));
            came_.back()[i] = Image<d>(v);
        }
    return true;
}

template <int d>
Periodic_insertion Periodic_inserter<d>::insert(const Scene& scene, Index v) {
    using enum Periodic_insertion::Outcome;
    begin(scene);
    const Coordinates<d>& p = scene.place[static_cast<std::size_t>(v)];
    const std::optional<Lifted_cell<d>> found = walk_to(scene.table, scene.lattice, scene.place, p);
    if (!found) return {not_local};
    const Places<d> x = places_of(scene, found->cell);
    for (std::size_t i = 0; i <= d; ++i)
        if (x[i] == scene.lattice.place(p, found->shift)) return {taken, scene.table.vertex[found->cell][i]};
    const Lifted_cell<d> first{found->cell, Offset<d>() - found->shift};  // p at offset 0
    return {find_cavity(scene, first, v) && settle(scene) ? done : not_local};
}

template <int d>
bool Periodic_inserter<d>::find_star(const Scene& scene, Lifted_cell<d> first, Index v) {
    const Image<d> centre(v);
    if (!enter(first)) return false;
    for (std::size_t k = 0; k < gone_.size(); ++k) {
        const Lifted_cell<d> g = gone_[k];
        const auto& vertices = scene.table.vertex[g.cell];
        if (std::count(vertices.begin(), vertices.end(), v) != 1) return false;
        for (std::size_t i = 0; i <= d; ++i)
            if (vertices[i] != v && !enter(beyond<d>(scene.table, g, i))) return false;
    }
    link_.clear();
    for (const Lifted_cell<d>& g : gone_)
        for (const Image<d>& s : scene.table.images(g.cell, g.shift))
            if (s != centre) link_.push_back(s);
    sort_unique(link_);
    link_places_.clear();
    for (const Image<d>& s : link_) {
        if (!is_near(s.label)) return false;
        link_places_.push_back(place_of(scene, s));
    }
    return true;
}

/// The cells that fill the star of v without it, in came_: cells of the Delaunay triangulation of its neighbours.
template <int d>
bool Periodic_inserter<d>::triangulate_link(const Scene& scene, Index v) {
    std::vector<Index> numbers(link_.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] = static_cast<Index>(k);
    if (!builder_.build(link_places_, numbers)) return false;

    std::vector<Facet_side<d>> border;  // seen from inside
    for (const Lifted_cell<d>& g : gone_) {
        const Cell_images<d> images = scene.table.images(g.cell, g.shift);
        Cell_sites<d> sites;
        int slot = 0;
        for (std::size_t i = 0; i <= d; ++i) {
            const bool is_centre = images[i].vertex == v;
            if (is_centre) slot = static_cast<int>(i);
            const auto number = std::lower_bound(link_.begin(), link_.end(), images[i]) - link_.begin();
            sites[i] = Site<d>(static_cast<Index>(is_centre ? static_cast<std::ptrdiff_t>(link_.size()) : number));
        }
        border.emplace_back(sites, slot);
    }
    const auto before = [](const Facet_side<d>& l, const Facet_side<d>& r) { return l.sites < r.sites; };
    std::sort(border.begin(), border.end(), before);

    struct Small_cell {
        Cell_sites<d> sites;
        std::array<std::uint32_t, static_cast<std::size_t>(d + 1)> across;
        std::array<bool, static_cast<std::size_t>(d + 1)> at_border;
        bool entered = false;
    };
    std::vector<Small_cell> small(builder_.cell_bound());
    std::vector<std::uint32_t> inside;
    std::size_t met = 0;  // facets of the border
    builder_.for_each_cell([&](std::uint32_t number, const Cell_sites<d>& sites, const auto& across) {
        Small_cell& cell = small[number];
        cell.sites = sites;
        cell.across = across;
        for (std::size_t i = 0; i <= d; ++i) {
            const Facet_side<d> side(sites, static_cast<int>(i));
            const auto [b, e] = std::equal_range(border.begin(), border.end(), side, before);
            cell.at_border[i] = b != e;
            if (b == e || b->left != side.left) continue;
            ++met;
            if (!cell.entered) inside.push_back(number);
            cell.entered = true;
        }
    });
    if (met != border.size()) return false;
    for (std::size_t k = 0; k < inside.size(); ++k) {
        const Small_cell& cell = small[inside[k]];
        Cell_images<d>& images = came_.emplace_back();
        for (std::size_t i = 0; i <= d; ++i) {
            if (cell.sites[i].vertex == infinite) return false;
            images[i] = link_[static_cast<std::size_t>(cell.sites[i].vertex)];
            const std::uint32_t next = cell.across[i] / 4;
            if (cell.at_border[i] || small[next].entered) continue;
            small[next].entered = true;
            inside.push_back(next);
        }
    }
    return true;
}

template <int d>
bool Periodic_inserter<d>::remove(const Scene& scene, Index v) {
    begin(scene);
    const Coordinates<d>& p = scene.place[static_cast<std::size_t>(v)];
    const std::optional<Lifted_cell<d>> found = walk_to(scene.table, scene.lattice, scene.place, p);
    if (!found) return false;
    const auto& vertices = scene.table.vertex[found->cell];
    if (std::find(vertices.begin(), vertices.end(), v) == vertices.end()) return false;
    const Lifted_cell<d> first{found->cell, Offset<d>() - found->shift};
    return find_star(scene, first, v) && triangulate_link(scene, v) && settle(scene);
}

/// Whether the new cells are positive and their facets Delaunay.
template <int d>
bool Periodic_inserter<d>::are_right(const Scene& scene) {
    const Periodic_table<d>& table = scene.table;
    for (const std::size_t c : region_.made())
        if (sign_of<d>(places_of(scene, c)) <= 0) return false;
    cospherical_.clear();
    for (const std::size_t c : region_.made()) {
        const Places<d> x = places_of(scene, c);
        const auto sphere = sphere_of<d>(x);
        const bool clear = sphere.positive();
        for (std::size_t i = 0; i <= d; ++i) {
            const Corner_index t = table.twin[c][i];
            const Coordinates<d> q =
                place_of(scene, table.image(table.cell_of(t), table.slot_of(t), table.translation(c, i)));
            if (clear && sphere.excludes(q)) continue;
            Tuple<d, d + 2> bicell{};
            for (std::size_t k = 0; k < d; ++k) bicell[k] = &x[k];
            bicell[d] = &q;
            bicell[d + 1] = &x[d];
            const int sign = exact_empty_sphere_sign(bicell).sign;
            if (sign < 0 || (sign == 0 && perturbed_sign(bicell) < 0)) return false;
            if (sign == 0) cospherical_.push_back(table.corner(c, i));
        }
    }
    return true;
}

/// Cells and their neighbours, and the last ones, which take the numbers of cells without a successor.
template <int d>
void Periodic_inserter<d>::keep_what_changes(const Scene& scene) const {
    if (scene.journal == nullptr) return;
    for (const Lifted_cell<d>& g : gone_) scene.journal->keep_around(scene.table, g.cell);
    for (std::size_t k = 1; came_.size() + k <= gone_.size(); ++k)
        scene.journal->keep_around(scene.table, scene.table.size() - k);
}

template <int d>
bool Periodic_inserter<d>::settle(const Scene& scene) {
    Periodic_table<d>& table = scene.table;
    cospherical_.reserve((d + 1) * came_.size());
    if (table.size() + came_.size() > static_cast<std::size_t>(Limits::cells) + gone_.size())
        throw Error(Error_code::too_large, "more than " + std::to_string(Limits::cells) + " cells");
    keep_what_changes(scene);
    if (!region_.replace(table, gone_, came_)) return false;
    if (!are_right(scene)) {
        region_.undo(table);
        return false;
    }
    const auto flag = [&](Corner_index h) -> std::uint8_t& {
        return table.cospherical[table.cell_of(h)][table.slot_of(h)];
    };
    const auto twin = [&](Corner_index h) { return table.twin[table.cell_of(h)][table.slot_of(h)]; };
    for (const std::size_t c : region_.made())
        for (std::size_t i = 0; i <= d; ++i) flag(table.twin[c][i]) = 0;
    for (const Corner_index h : cospherical_) flag(h) = flag(twin(h)) = 1;
    region_.keep(table);
    return true;
}

template class Periodic_inserter<2>;
template class Periodic_inserter<3>;

}  // namespace annulus::inline v1
