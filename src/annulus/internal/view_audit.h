// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Cgal_view: whether CGAL's object is still as update() made it. Its handles allow callers to write in it although it
// is const.
#include <annulus/audit.h>
#include <annulus/internal/view.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>
#include <unordered_map>

namespace annulus::inline v1 {

namespace detail {

inline void object_fault(Audit_result& result, const std::string& words) {
    if (result.topological_faults++ == 0) result.first_fault = words;
}
template <std::size_t n>
[[nodiscard]] std::string written(const std::array<double, n>& x) {
    std::string s = "(";
    for (const double c : x) {
        std::array<char, 32> text{};
        (void)std::snprintf(text.data(), text.size(), s.size() > 1 ? ", %.17g" : "%.17g", c);
        s += text.data();
    }
    return s + ")";
}

}  // namespace detail

/// Audits the vertices: each is ours, at its position in x, in the cell that it names, and none is missing. False
/// when a cell has a vertex that is not ours.
template <class Traits>
bool Cgal_view<Traits>::audit_vertices(std::span<const Coordinates<d>> x, Audit_result& result) const {
    const auto ours = [this](Vertex_handle v) {
        return v != Vertex_handle() && (v == tr_.infinite_vertex() || index(v) >= 0);
    };
    std::size_t found = 0;
    auto& tds = tr_.tds();
    for (auto it = tds.vertices().begin(); it != tds.vertices().end(); ++it) {
        const Vertex_handle v = it;
        if (v == tr_.infinite_vertex()) continue;
        if (!ours(v)) {
            detail::object_fault(
                result, "CGAL's object has a vertex whose index is not its own: " + std::to_string(numbers_.of(v)));
            continue;
        }
        const Index i = index(v);
        ++found;
        if (tr_.dimension() == d && (Traits::cell_of(v) == Cell_handle() || !Traits::cell_of(v)->has_vertex(v)))
            detail::object_fault(
                result, "the cell that CGAL's object has for vertex " + std::to_string(i) + " is not around it");
        const Coordinates<d> place = coordinates(v->point());
        if (place != x[at(i)])
            detail::object_fault(result, "the point of vertex " + std::to_string(i) + " in CGAL's object is " +
                                             detail::written(place) + ", not " + detail::written(x[at(i)]));
    }
    const auto present = static_cast<std::size_t>(
        std::count_if(handle_.begin(), handle_.end(), [](Vertex_handle v) { return v != Vertex_handle(); }));
    if (found != present)
        detail::object_fault(
            result, "CGAL's object has " + std::to_string(found) + " of " + std::to_string(present) + " vertices");
    if (tr_.dimension() < 1) return true;
    bool named = true;
    for (auto c = Traits::cells(tds).begin(); c != Traits::cells(tds).end(); ++c)
        for (int i = 0; i <= tr_.dimension(); ++i)
            if (named && !ours(c->vertex(i))) {
                named = false;
                detail::object_fault(result, "a cell of CGAL's object has a vertex that is none of its own");
            }
    return named;
}

/// Audits cells of dimension d: neighbours share a facet, mutually, and the mesh has the same neighbours.
template <class Traits>
void Cgal_view<Traits>::audit_adjacency(Audit_result& result) const {
    const auto written = [this](Cell_handle c) {
        std::string s;
        for (const Index v : points_of(c)) s.append(1, ' ').append(v == infinite ? "infinity" : std::to_string(v));
        return s;
    };
    // Whether the facet of c opposite to slot i is that of n opposite to slot j.
    const auto glued = [](Cell_handle c, int i, Cell_handle n, int j) {
        for (int k = 0; k <= d; ++k)
            if (k != i && (!n->has_vertex(c->vertex(k)) || n->index(c->vertex(k)) == j)) return false;
        return true;
    };
    const Table_cells<d> t = mesh_.cells();
    std::unordered_map<const Cell*, Cell_index> numbers;  // of cells whose base has no place for one
    if constexpr (!Has_number<Cell>)
        for (const Cell_index c : t.cells())
            if (cell_.has(c) && cell_[c] != Cell_handle()) numbers[&*cell_[c]] = c;
    const auto number_of = [&](Cell_handle c) {
        if constexpr (Has_number<Cell>) {
            return Cell_index(c->cell());
        } else {
            const auto it = numbers.find(&*c);
            return it == numbers.end() ? no_cell : it->second;
        }
    };
    std::size_t found = 0;
    Traits::for_each_cell(tr_, [&](Cell_handle c) {
        const Cell_index number = number_of(c);
        const bool known = number.value() >= 0 && number < t.cell_bound() && cell_.has(number) && cell_[number] == c &&
                           t.is_cell(number) && t.vertices(number) == points_of(c);
        if (known) ++found;
        else detail::object_fault(result, "the mesh has not the cell of CGAL's object" + written(c));
        for (int i = 0; i <= d; ++i) {
            const Cell_handle n = c->neighbor(i);
            bool back = false;
            for (int j = 0; j <= d && n != Cell_handle(); ++j)
                back = back || (n->neighbor(j) == c && glued(c, i, n, j));
            if (!back)
                detail::object_fault(
                    result, "a neighbour that CGAL's object has for this cell shares no facet with it:" + written(c));
            else if (known && number_of(n) != t.cell_of(t.twin(t.corner(number, i))))
                detail::object_fault(result,
                                     "the mesh has another neighbour for the cell of CGAL's object" + written(c));
        }
    });
    std::size_t cells = 0;
    for (const Cell_index c : t.cells()) cells += t.is_cell(c) ? 1U : 0U;
    if (cells != found) detail::object_fault(result, "the mesh has cells that CGAL's object has not");
}

template <class Traits>
auto Cgal_view<Traits>::points_of(Cell_handle c) const -> Points {
    Points x{};
    for (int i = 0; i <= d; ++i)
        x[static_cast<std::size_t>(i)] = tr_.is_infinite(c->vertex(i)) ? infinite : numbers_.of(c->vertex(i));
    return x;
}

template <class Traits>
bool Cgal_view<Traits>::audit(std::span<const Coordinates<d>> x, Audit_result& result) const {
    if (!audit_vertices(x, result)) return false;
    if (tr_.dimension() == d) audit_adjacency(result);
    return true;
}

}  // namespace annulus::inline v1
