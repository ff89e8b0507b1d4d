// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/limits.h>
#include <annulus/error.h>
#include <annulus/internal/dirty_cells.h>
#include <annulus/internal/grow.h>
#include <annulus/internal/index.h>
#include <annulus/mesh/change_log.h>
#include <annulus/mesh/small_set.h>
#include <annulus/space/euclidean.h>
#include <annulus/types.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus::inline v1 {

/*
         q = site(h)
        / \
       / h \             cell c = cell_of(h); its corners h, ccw(h), cw(h) are counter-clockwise:
      /     \            ccw(h) is at a, cw(h) is at b
     /       \
    a---------b          the facet a b, opposite to h and to twin(h)
     \       /
      \     /
       \ t /             the cell beyond, with its corner t = twin(h)
        \ /
         p = site(t) = opposite(h)
*/
/// The combinatorics of a triangulation of S and infinity in flat arrays: what the strategies walk over.
///
/// Cell c has d + 1 corners h = 4c + i; i is the slot of h. Corner h has a vertex, and it names the facet opposite to
/// it as seen from c (a half-facet). `twin(h)` is the same facet seen from the other side, so `site(h)` and
/// `opposite(h)` are the opposite corners of the bi-cell (the picture: 2D).
///
/// A facet has the index of the lesser of its two half-facets, which changes with its cells; nothing is stored for
/// facets. Cells are positively oriented (predicate/filtered_3.h). Functions of one
/// cell or corner are O(1), new_cell and free_cell amortised; those of all are O(n).
template <int d>
class Corner_table {
  public:
    static constexpr Index stride = 4;  // also in 2D: corners are found by shifts, and a cell is one 16-byte line

    /// Exclusive bounds of the indices in use. There are holes below them (more than half of the indices of facets).
    [[nodiscard]] Cell_index cell_bound() const { return cell_of(facet_bound()); }
    [[nodiscard]] Corner_index facet_bound() const { return Corner_index(static_cast<Index>(twin_.size())); }
    [[nodiscard]] Index vertex_bound() const { return static_cast<Index>(corner_of_vertex_.size()); }
    [[nodiscard]] bool is_cell(Cell_index c) const { return vertex(corner(c, 0)) != none; }
    /// Whether f is the index of a facet: a half-facet of a cell that exists, and the lesser of the two.
    [[nodiscard]] bool is_facet(Corner_index f) const { return slot_of(f) <= d && is_cell(cell_of(f)) && f < twin(f); }
    /// All cells and all facets, each once.
    [[nodiscard]] auto cells() const {
        return Index_range(cell_bound(), [this](Cell_index c) { return is_cell(c); });
    }
    [[nodiscard]] auto finite_cells() const {
        return Index_range(cell_bound(), [this](Cell_index c) { return is_cell(c) && !is_infinite(c); });
    }
    [[nodiscard]] auto facets() const {
        return Index_range(facet_bound(), [this](Corner_index f) { return is_facet(f); });
    }

    [[nodiscard]] static constexpr Cell_index cell_of(Corner_index h) { return Cell_index(h.value() >> 2); }
    [[nodiscard]] static constexpr int slot_of(Corner_index h) { return static_cast<int>(h.value() & 3); }
    [[nodiscard]] static constexpr Corner_index corner(Cell_index c, int i) {
        return Corner_index(stride * c.value() + i);
    }

    [[nodiscard]] Index vertex(Corner_index h) const { return vertex_[h]; }
    [[nodiscard]] Corner_index twin(Corner_index h) const { return twin_[h]; }
    /// These two by corner.
    [[nodiscard]] std::span<const Index> vertex_array() const { return vertex_; }
    [[nodiscard]] std::span<const Corner_index> twin_array() const { return twin_; }
    [[nodiscard]] Site<d> site(Corner_index h) const { return Site<d>(vertex(h)); }
    /// Brings the site of twin(h) into the cache.
    void prefetch_opposite(Corner_index h) const {
        if (const Corner_index t = twin(h); t != no_corner) __builtin_prefetch(&vertex_[t]);
    }
    /// The site of twin(h), as seen from the cell of h.
    [[nodiscard]] Site<d> opposite(Corner_index h) const { return site(twin(h)); }
    /// The facet of which h is one half.
    [[nodiscard]] Corner_index facet(Corner_index h) const { return std::min(h, twin(h)); }
    /// A corner whose vertex is v; `no_corner` for a vertex that is not in the triangulation.
    [[nodiscard]] Corner_index corner_of(Index v) const { return corner_of_vertex_[at(v)]; }

    /// A corner at infinity. Precondition: there are cells.
    [[nodiscard]] Corner_index corner_of_infinity() const {
        assert(vertex(corner_of_infinity_) == infinite && is_cell(cell_of(corner_of_infinity_)));
        return corner_of_infinity_;
    }

    [[nodiscard]] bool is_infinite(Cell_index c) const {
        for (int i = 0; i <= d; ++i)
            if (vertex(corner(c, i)) == infinite) return true;
        return false;
    }
    /// The slot of s in c, or -1.
    [[nodiscard]] int slot(Cell_index c, Site<d> s) const {
        for (int i = 0; i <= d; ++i)
            if (site(corner(c, i)) == s) return i;
        return -1;
    }
    [[nodiscard]] int slot_of_infinity(Cell_index c) const { return slot(c, Site<d>(infinite)); }

    /// Calls visit(h) for each corner h whose vertex is v, which may be `infinite`. O(degree); counter-clockwise in
    /// 2D, in no particular order in 3D. `visit` must not change the table.
    template <class Visit>
    void for_each_corner(Index v, Visit visit) const {
        if constexpr (d == 2) {
            const Corner_index first = v == infinite ? corner_of_infinity() : corner_of(v);
            Corner_index h = first;
            do {
                assert(vertex(h) == v);
                visit(h);
                h = next_around(h);
            } while (h != first);
        } else {
            boost::container::small_vector<Corner_index, 64> star;
            Small_set<Cell_index, Index_hash> met(no_cell);
            const auto enter = [&](Cell_index c) {
                __builtin_prefetch(&twin_[corner(c, 0)]);
                __builtin_prefetch(&vertex_[corner(c, 0)]);
                if (met.insert(c)) star.push_back(corner(c, 0));
            };
            enter(cell_of(v == infinite ? corner_of_infinity() : corner_of(v)));
            for (std::size_t k = 0; k < star.size(); ++k) {
                const Cell_index c = cell_of(star[k]);
                // The slot of v, computed without branches, which would not be predictable.
                const auto is = [&](int i) { return vertex(corner(c, i)) == v ? 1 : 0; };
                const int slot = is(1) + 2 * is(2) + 3 * is(3);
                star[k] = corner(c, slot);
                for (int i = 1; i <= d; ++i) enter(cell_of(twin(corner(c, (slot + i) & 3))));
            }
            for (const Corner_index h : star) visit(h);
        }
    }

    /// 2D: the corner of the same vertex in the next triangle counter-clockwise.
    [[nodiscard]] Corner_index next_around(Corner_index h) const {
        static_assert(d == 2);
        const Corner_index t = twin(ccw(h));
        return ccw(t);
    }
    /// 2D: the corners that follow and precede h in its triangle.
    [[nodiscard]] static constexpr Corner_index ccw(Corner_index h) {
        return Corner_index(slot_of(h) == 2 ? h.value() - 2 : h.value() + 1);
    }
    [[nodiscard]] static constexpr Corner_index cw(Corner_index h) {
        return Corner_index(slot_of(h) == 0 ? h.value() + 2 : h.value() - 1);
    }

    /// Removes all cells. Then there are `vertices` vertices, none of which is in the triangulation.
    void clear(std::size_t vertices);
    /// The same with this many cells; set_cell must follow for each of them. Throws Error(too_large).
    void reset_to(std::size_t vertices, std::size_t cells);
    /// Reserves the memory that reset_to(vertices, cells) needs. Throws bad_alloc, with nothing changed.
    void reserve(std::size_t vertices, std::size_t cells) {
        vertex_.reserve(4 * cells);
        twin_.reserve(4 * cells);
        corner_of_vertex_.reserve(vertices);
    }
    void set_vertex_bound(std::size_t vertices) { corner_of_vertex_.resize(vertices, no_corner); }

    /// A new cell without vertices and twins; is_cell() is false until it has them. Throws Error(too_large) when its
    /// corners would have no index.
    [[nodiscard]] Cell_index new_cell();
    void free_cell(Cell_index c);
    void set_site(Corner_index h, Site<d> s) {
        record(cell_of(h));
        vertex_[h] = s.vertex;
        note_corner(s.vertex, h);
    }
    /// After reset_to. Several threads may set different cells at once. set_corner must follow for each vertex.
    void set_cell(Cell_index c, const std::array<Index, static_cast<std::size_t>(d + 1)>& vertices,
                  const std::array<Corner_index, static_cast<std::size_t>(d + 1)>& twins) {
        Index* const v = &vertex_[corner(c, 0)];
        Corner_index* const t = &twin_[corner(c, 0)];
        for (std::size_t i = 0; i <= d; ++i) {
            v[i] = vertices[i];
            t[i] = twins[i];
        }
    }
    /// The same for one twin, in one direction only.
    void set_twin_only(Corner_index h, Corner_index t) { twin_[h] = t; }
    /// Sets the corner of v, which may be `infinite`.
    void set_corner(Index v, Corner_index h) { note_corner(v, h); }
    /// How many times a cell was written to, or all of them were replaced: equal numbers, equal cells.
    [[nodiscard]] std::uint64_t writes() const noexcept { return writes_; }
    /// Sets the log whose record() is called before a place is written to; nullptr: none.
    void set_observer(Change_log<d>* log) noexcept { change_log_ = log; }
    /// The same for dirty cells, until clear_dirty_cells() or the end of the table's life.
    void set_dirty_cells(Dirty_cells& log) noexcept { dirty_cells_ = &log; }
    void clear_dirty_cells() noexcept { dirty_cells_ = nullptr; }
    void set_absent(Index v) { corner_of_vertex_[at(v)] = no_corner; }
    /// Makes h and t the two sides of a facet.
    void set_adjacency(Corner_index h, Corner_index t) {
        twin_[h] = t;
        twin_[t] = h;
    }

    /*
           q                      q
          /h\                    /|\
         /   \                  /h| \
        a-----b       ->       a  |  b
         \   /                  \ |t/
          \t/                    \|/
           p                      p
    */
    /// 2D: replaces the edge opposite to corner h by the other diagonal of its bi-cell. Precondition: the opposite
    /// vertices are not adjacent. proofs/coq/plane_table.v has it corner by corner. In the picture t = twin(h).
    /// Infinity is a vertex like any other. h and t keep their vertices; ccw(h) and ccw(t) then name the new edge p q.
    void flip(Corner_index h);

  private:
    static std::size_t at(Index v) { return static_cast<std::size_t>(v); }
    [[noreturn]] static void throw_too_large() {
        throw Error(Error_code::too_large, "more than " + std::to_string(Limits::cells) + " cells");
    }
    void record(Cell_index c) noexcept {
        ++writes_;
        if (change_log_ != nullptr) [[unlikely]]
            change_log_->record(c, *this);
        if (dirty_cells_ != nullptr) [[unlikely]]
            dirty_cells_->record(c, twin_.size() / 4);
    }
    void record_all() noexcept {
        ++writes_;
        if (change_log_ != nullptr) change_log_->record_all(*this);
        if (dirty_cells_ != nullptr) dirty_cells_->record_all();
    }
    void note_corner(Index v, Corner_index h) { (v == infinite ? corner_of_infinity_ : corner_of_vertex_[at(v)]) = h; }

    Corner_index corner_of_infinity_;
    By_corner<Index> vertex_;  // `none` at the first corner where there is no cell
    By_corner<Corner_index> twin_;
    std::vector<Corner_index> corner_of_vertex_;  // by vertex
    std::vector<Cell_index> free_cells_;
    Change_log<d>* change_log_ = nullptr;
    Dirty_cells* dirty_cells_ = nullptr;
    std::uint64_t writes_ = 0;
};

template <int d>
void Corner_table<d>::clear(std::size_t vertices) {
    record_all();
    vertex_.clear();
    twin_.clear();
    free_cells_.clear();
    corner_of_vertex_.assign(vertices, no_corner);
}

/// Old contents are overwritten, not cleared first. In 2D slot 3 is always `none`.
template <int d>
void Corner_table<d>::reset_to(std::size_t vertices, std::size_t cells) {
    if (cells > static_cast<std::size_t>(Limits::cells)) throw_too_large();
    record_all();
    free_cells_.clear();
    corner_of_vertex_.assign(vertices, no_corner);
    vertex_.resize(4 * cells, none);
    twin_.resize(4 * cells, no_corner);
}

template <int d>
Cell_index Corner_table<d>::new_cell() {
    Cell_index c;
    if (!free_cells_.empty()) {
        c = free_cells_.back();
        free_cells_.pop_back();
    } else {
        c = cell_bound();
        if (c.value() >= Limits::cells) throw_too_large();
        grow(vertex_, twin_.size() + 4, none);
        grow(twin_, twin_.size() + 4, no_corner);
    }
    return c;
}

template <int d>
void Corner_table<d>::free_cell(Cell_index c) {
    free_cells_.push_back(c);  // first, because it may throw
    record(c);
    vertex_[corner(c, 0)] = none;
}

}  // namespace annulus::inline v1

#include <annulus/mesh/corner_table_flip.h>
