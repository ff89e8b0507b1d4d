// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>
#include <annulus/arithmetic/error.h>
#include <annulus/arithmetic/horizons.h>
#include <annulus/mesh/grow.h>
#include <annulus/mesh/small_set.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace annulus {

/// The combinatorics of a triangulation of S and infinity in flat arrays: what the filter walks over.
///
/// Cell c has d + 1 corners h = 4c + i. Corner h carries a vertex and stands for the facet opposite to it, seen from c
/// (a half-facet). `twin(h)` is the same facet seen from the other side, so `vertex(h)` and `vertex(twin(h))` are the
/// opposite vertices of the bi-cell. A facet has the index of the lesser of its two half-facets, which changes with its
/// cells; nothing is stored of it. Cells are positively oriented as in CGAL, whose triangulation this mirrors corner by
/// corner. All operations are O(1) unless they say otherwise.
template <int d>
class Cell_table {
  public:
    static constexpr Index stride = 4;  // also in 2D: corners are found by shifts, and a cell is one 16-byte line

    /// The cells and facets that exist: indices below these bounds, holes among them (more than half of facets').
    [[nodiscard]] Index cell_bound() const { return static_cast<Index>(alive_.size()); }
    [[nodiscard]] Index facet_bound() const { return static_cast<Index>(twin_.size()); }
    [[nodiscard]] Index vertex_bound() const { return static_cast<Index>(corner_of_vertex_.size()); }
    [[nodiscard]] bool is_cell(Index c) const { return alive_[at(c)] != 0; }
    /// That f is the index of a facet: a half-facet of a cell that exists, and the lesser of the two.
    [[nodiscard]] bool is_facet(Index f) const { return slot_of(f) <= d && is_cell(cell_of(f)) && f < twin(f); }

    [[nodiscard]] static constexpr Index cell_of(Index h) { return h >> 2; }
    [[nodiscard]] static constexpr int slot_of(Index h) { return static_cast<int>(h & 3); }
    [[nodiscard]] static constexpr Index corner(Index c, int i) { return 4 * c + i; }

    [[nodiscard]] Index vertex(Index h) const { return vertex_[at(h)]; }
    [[nodiscard]] Index twin(Index h) const { return twin_[at(h)]; }
    /// The facet that h is a half of.
    [[nodiscard]] Index facet(Index h) const { return std::min(h, twin(h)); }
    /// A corner whose vertex is v; `none` for a vertex that is not in the triangulation.
    [[nodiscard]] Index corner_of(Index v) const { return corner_of_vertex_[at(v)]; }

    /// A corner at infinity. Precondition: there are cells.
    [[nodiscard]] Index corner_of_infinity() const {
        assert(vertex(corner_of_infinity_) == infinite && is_cell(cell_of(corner_of_infinity_)));
        return corner_of_infinity_;
    }

    [[nodiscard]] bool is_infinite(Index c) const {
        for (int i = 0; i <= d; ++i)
            if (vertex(corner(c, i)) == infinite) return true;
        return false;
    }
    /// The slot of v in c, or -1.
    [[nodiscard]] int slot(Index c, Index v) const {
        for (int i = 0; i <= d; ++i)
            if (vertex(corner(c, i)) == v) return i;
        return -1;
    }

    /// Calls visit(h) for each corner h whose vertex is v, which may be `infinite`. O(degree); counter-clockwise in 2D, in
    /// no particular order in 3D. `visit` must not change the table.
    template <class Visit>
    void for_each_corner(Index v, Visit visit) const requires(d == 3) {
        boost::container::small_vector<Index, 64> star;
        Small_set<Index, Index_hash> met(none);
        const auto enter = [&](Index c) {
            if (!met.insert(c)) return;
            // Its slot without branches, which nobody could predict.
            const auto is = [&](int i) { return vertex(corner(c, i)) == v ? 1 : 0; };
            star.push_back(corner(c, is(1) + 2 * is(2) + 3 * is(3)));
        };
        enter(cell_of(v == infinite ? corner_of_infinity() : corner_of(v)));
        for (std::size_t k = 0; k < star.size(); ++k) {
            const Index c = cell_of(star[k]);
            for (int i = 0; i <= d; ++i)
                if (corner(c, i) != star[k]) enter(cell_of(twin(corner(c, i))));
        }
        for (const Index h : star) visit(h);
    }
    template <class Visit>
    void for_each_corner(Index v, Visit visit) const requires(d == 2) {
        const Index first = corner_of(v);
        Index h = first;
        do {
            assert(vertex(h) == v);
            visit(h);
            h = next_around(h);
        } while (h != first);
    }

    /// 2D: the corner of the same vertex in the next triangle counter-clockwise.
    [[nodiscard]] Index next_around(Index h) const requires(d == 2) {
        const Index t = twin(ccw(h));
        return ccw(t);
    }
    /// 2D: the corners that follow and precede h in its triangle.
    [[nodiscard]] static constexpr Index ccw(Index h) { return slot_of(h) == 2 ? h - 2 : h + 1; }
    [[nodiscard]] static constexpr Index cw(Index h) { return slot_of(h) == 0 ? h + 2 : h - 1; }

    /// Starts afresh: no cells, `vertices` vertices none of which is in the triangulation.
    void clear(std::size_t vertices);
    /// The same with this many cells, which have no vertices or twins yet. Throws Error(too_large).
    void clear(std::size_t vertices, std::size_t cells);
    void set_vertex_bound(std::size_t vertices) { corner_of_vertex_.resize(vertices, none); }

    /// A new cell with no vertices or twins yet. Throws Error(too_large) when its corners would have no index.
    [[nodiscard]] Index new_cell();
    void free_cell(Index c);
    void set_vertex(Index h, Index v) {
        vertex_[at(h)] = v;
        note_corner(v, h);
    }
    void set_absent(Index v) { corner_of_vertex_[at(v)] = none; }
    /// Makes h and t the two sides of a facet.
    void glue(Index h, Index t) {
        twin_[at(h)] = t;
        twin_[at(t)] = h;
    }

    /// 2D: replaces the edge opposite to corner h by the other diagonal of its bi-cell, corner for corner as CGAL's
    /// `flip(face, i)` does. Precondition: the opposite vertices are not adjacent.
    void flip(Index h) requires(d == 2);

    /// 3D: the next cell around an edge. h and k are the two corners of one cell whose vertices are not on the edge; on
    /// return they are those of the cell across the facet opposite to k, and k is again the one to go on with.
    void turn(Index& h, Index& k) const requires(d == 3) {
        const Index t = twin(k);
        const Index c = cell_of(t);
        const int i = slot(c, vertex(h));
        h = t;
        k = corner(c, i);
    }

  private:
    static std::size_t at(Index i) { return static_cast<std::size_t>(i); }
    [[noreturn]] static void throw_too_large() {
        throw Error(Error_code::too_large, "more than " + std::to_string(Horizons::cells) + " cells");
    }
    void note_corner(Index v, Index h) { (v == infinite ? corner_of_infinity_ : corner_of_vertex_[at(v)]) = h; }

    Index corner_of_infinity_ = none;
    std::vector<Index> vertex_;            // by corner
    std::vector<Index> twin_;              // by corner
    std::vector<char> alive_;              // by cell
    std::vector<Index> corner_of_vertex_;  // by vertex
    std::vector<Index> free_cells_;
};

template <int d>
void Cell_table<d>::clear(std::size_t vertices) {
    vertex_.clear();
    twin_.clear();
    alive_.clear();
    free_cells_.clear();
    corner_of_vertex_.assign(vertices, none);
}

template <int d>
void Cell_table<d>::clear(std::size_t vertices, std::size_t cells) {
    if (cells > static_cast<std::size_t>(Horizons::cells)) throw_too_large();
    clear(vertices);
    vertex_.assign(4 * cells, none);
    twin_.assign(4 * cells, none);
    alive_.assign(cells, 1);
}

template <int d>
Index Cell_table<d>::new_cell() {
    Index c = none;
    if (!free_cells_.empty()) {
        c = free_cells_.back();
        free_cells_.pop_back();
    } else {
        c = cell_bound();
        if (c >= Horizons::cells) throw_too_large();
        grow(alive_, alive_.size() + 1);
        grow(vertex_, vertex_.size() + 4, none);
        grow(twin_, twin_.size() + 4, none);
    }
    alive_[at(c)] = 1;
    return c;
}

template <int d>
void Cell_table<d>::free_cell(Index c) {
    alive_[at(c)] = 0;
    free_cells_.push_back(c);
}

template <int d>
void Cell_table<d>::flip(Index h) requires(d == 2) {
    const Index t = twin(h);
    const Index a = vertex(ccw(h));
    const Index b = vertex(cw(h));
    const Index h_side = twin(ccw(h));  // across the edge b p
    const Index t_side = twin(ccw(t));  // across the edge a q
    // (p, a, b) becomes (p, a, q); (q, b, a) becomes (q, b, p).
    vertex_[at(cw(h))] = vertex(t);
    vertex_[at(cw(t))] = vertex(h);
    glue(h, t_side);
    glue(t, h_side);
    glue(ccw(h), ccw(t));
    note_corner(a, ccw(h));
    note_corner(b, ccw(t));
    note_corner(vertex(h), h);
    note_corner(vertex(t), t);
}

}  // namespace annulus
