// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cgal/mesh_embedding.h>

#include <annulus/arithmetic/error.h>
#include <annulus/cgal/copy_cells.h>
#include <annulus/cgal/insertion_order.h>
#include <annulus/cgal/traits_2.h>
#include <annulus/cgal/traits_3.h>
#include <annulus/mesh/insert_vertex.h>
#include <annulus/mesh/replace_cells.h>
#include <annulus/mesh/table_readings.h>
#include <annulus/mesh/walk.h>

#include <algorithm>
#include <exception>
#include <limits>
#include <type_traits>

namespace annulus {

/// What knows CGAL.
template <int d>
struct Mesh_embedding<d>::Builder {
    using Traits = std::conditional_t<d == 2, Cgal_traits_2<No_info>, Cgal_traits_3<No_info>>;
    using Triangulation = typename Traits::Triangulation;
    using Cell_handle = typename Traits::Cell_handle;
    using Vertex_handle = typename Traits::Vertex_handle;

    Insertion_order<d> order;

    /// Throws Error(collision).
    template <class Lives>
    void insert(Triangulation& tr, std::span<const Coordinates<d>> x, Lives lives, int threads) {
        const std::span<const Index> sorted = order.of(x, lives, threads);
        std::exception_ptr collision;  // thrown outside, where the thread's table is known to be sound
        Traits::edit([&] {
            try {
                insert_in_order<Traits>(tr, x, sorted, [](Vertex_handle v, Index i) { v->set_index(i); });
            } catch (const Error&) {
                collision = std::current_exception();
            }
        });
        if (collision) std::rethrow_exception(collision);
    }

    static void copy(Triangulation& tr, std::size_t bound, Cell_table<d>& table, int threads) {
        std::vector<Cell_handle> cells;
        cells.reserve(Traits::cells(tr.tds()).size());
        Traits::for_each_cell(tr, [&](Cell_handle c) { cells.push_back(c); });
        copy_cells<Traits>(tr, cells, bound, table, threads);
    }

    static void list_flat(const Triangulation& tr, std::vector<Index>& cells) {
        const auto list = [&](auto cell, int corners) {
            for (int i = 0; i <= d; ++i) cells.push_back(i < corners ? cell->vertex(i)->index() : none);
        };
        if constexpr (d == 3)
            if (tr.dimension() == 2)
                for (auto f = tr.finite_facets_begin(); f != tr.finite_facets_end(); ++f) list(f->first, 3);
        if (tr.dimension() == 1)
            for (auto e = tr.finite_edges_begin(); e != tr.finite_edges_end(); ++e) list(e->first, 2);
    }
};

template <int d>
Mesh_embedding<d>::Mesh_embedding() : builder_(std::make_unique<Builder>()) {}
template <int d>
Mesh_embedding<d>::~Mesh_embedding() = default;

template <int d>
void Mesh_embedding<d>::build(std::span<const Coordinates<d>> x) {
    builder_->order.forget();
    present_.assign(x.size(), 1);
    vertices_ = x.size();
    rebuild(x);
}

template <int d>
void Mesh_embedding<d>::rebuild(std::span<const Coordinates<d>> x) {
    typename Builder::Triangulation tr;
    builder_->insert(tr, x, [this](Index i) { return has(i); }, this->threads_);
    std::vector<Index> flat;
    Cell_table<d> table;
    table.clear(x.size());
    if (tr.dimension() == d) Builder::copy(tr, x.size(), table, this->threads_);
    else Builder::list_flat(tr, flat);
    flat_cells_ = std::move(flat);
    table_.become(std::move(table));
    dimension_ = tr.dimension();
}

template <int d>
bool Mesh_embedding<d>::rebuild_sorts(std::span<const Coordinates<d>> x) const {
    return builder_->order.sorts(x);
}

template <int d>
void Mesh_embedding<d>::restore(std::span<const Coordinates<d>> x, Index fresh) {
    if (fresh != none && at(fresh) < present_.size()) present_[at(fresh)] = 0;
    present_.resize(x.size(), 0);
    vertices_ = static_cast<std::size_t>(std::count(present_.begin(), present_.end(), char{1}));
    builder_->order.forget();
    rebuild(x);
}

template <int d>
void Mesh_embedding<d>::clear_cells() noexcept {
    table_.clear(0);
    flat_cells_.clear();
    dimension_ = -1;
}

template <int d>
bool Mesh_embedding<d>::delaunay_of(std::span<const Coordinates<d>> x, std::span<const Index> vertices,
                                    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>>& cells) {
    return cgal_delaunay_of<typename Builder::Traits>(x, vertices, cells);
}

/// The same under other numbers, all of which `made` receives: the table does not become smaller, since the engine may have noted some.
template <int d>
void Mesh_embedding<d>::replace_everything(std::span<const Coordinates<d>> x, std::vector<Cell_index>& made) {
    std::vector<Index> vertices;
    for (std::size_t v = 0; v < present_.size(); ++v)
        if (present_[v] != 0) vertices.push_back(static_cast<Index>(v));
    std::vector<Cell_points<d>> cells;
    if (!delaunay_of(x, vertices, cells)) throw Error(Error_code::collision, "two vertices are at one place");
    std::vector<Cell_index> old;
    for (const Cell_index c : table_.cells()) old.push_back(c);
    replace_cells<d>(table_, old, cells, made);
}

/// Of what was listed from `first` on those that there are, once.
template <int d>
void Mesh_embedding<d>::keep_present(std::vector<Cell_index>& cells, std::size_t first) const {
    const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, cells.end());
    const auto gone = [this](Cell_index c) { return !table_.is_cell(c); };
    cells.erase(std::remove_if(begin, std::unique(begin, cells.end()), gone), cells.end());
}

/// What is outside of them is Delaunay there, and so were they.
template <int d>
void Mesh_embedding<d>::restore_cells(std::span<const Coordinates<d>> home, std::span<const Cell_index> cells,
                                      std::vector<Cell_index>& made) {
    std::vector<Cell_index> present;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(present),
                 [this](Cell_index c) { return table_.is_cell(c); });
    const std::size_t first = made.size();
    if (!local_.rebuild(home, present, std::numeric_limits<double>::infinity(), made)) {
        replace_everything(home, made);
    }
    keep_present(made, first);
}

template <int d>
Cell_index Mesh_embedding<d>::locate(std::span<const Coordinates<d>> home, const Coordinates<d>& p, Index own) {
    const auto lives = [this](Index v) { return has(v) && table_.corner_of(v) != no_corner; };
    const Index near = landmarks_.near(home, present_.size(), p, own, lives);
    std::size_t steps = 0;
    const Corner_index start = near != none ? table_.corner_of(near) : table_.corner_of_infinity();
    const Cell_index c = walk_to<d>(Table_walker<d>(table_, home), p, table_.cell_of(start), steps);
    landmarks_.note(Landmarks<d>::nearest(home, cell_points(table_, c), p, own), steps);
    return c;
}

template <int d>
bool Mesh_embedding<d>::is_taken(std::span<const Coordinates<d>> home, const Coordinates<d>& p, Index but) {
    if (dimension_ < d) {
        for (std::size_t v = 0; v < present_.size(); ++v)
            if (present_[v] != 0 && static_cast<Index>(v) != but && home[v] == p) return true;
        return false;
    }
    return is_at_corner(home, p, locate(home, p, but), but);
}

/// Whether a vertex of c, but one, is at p.
template <int d>
bool Mesh_embedding<d>::is_at_corner(std::span<const Coordinates<d>> home, const Coordinates<d>& p, Cell_index c,
                                     Index but) const {
    const auto points = cell_points(table_, c);
    const auto is_there = [&](Index v) { return v != infinite && v != but && home[at(v)] == p; };
    return std::any_of(points.begin(), points.end(), is_there);
}

/// v goes to p, where there is no vertex, in the cell `place`.
template <int d>
void Mesh_embedding<d>::attach(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p, Cell_index place,
                               std::vector<Cell_index>& changed) {
    const Coordinates<d> old = std::exchange(home[at(v)], p);
    const std::size_t first = changed.size();
    try {
        insert_vertex<d>(table_, home, place, v, changed);
    } catch (...) {
        home[at(v)] = old;
        throw;
    }
    keep_present(changed, first);
}

/// False, with nothing changed, when the rest would be flat.
template <int d>
bool Mesh_embedding<d>::detach(std::span<const Coordinates<d>> home, Index v, std::vector<Cell_index>& changed) {
    if (dimension_ != d || vertices_ <= d + 1U) return false;
    std::vector<Cell_index> star;
    table_.for_each_corner(v, [&](Corner_index h) { star.push_back(table_.cell_of(h)); });
    const std::size_t first = changed.size();
    if (!local_.remove(home, star, v, changed)) return false;
    keep_present(changed, first);
    table_.set_absent(v);
    return true;
}

template <int d>
bool Mesh_embedding<d>::insert(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p, std::vector<Cell_index>& changed) {
    const bool flat = dimension_ < d;
    const Cell_index place = flat ? no_cell : locate(home, p, none);
    if (flat ? is_taken(home, p, none) : is_at_corner(home, p, place, none)) return false;
    builder_->order.note_coming(v);
    if (at(v) >= present_.size()) present_.resize(at(v) + 1, 0);
    present_[at(v)] = 1;
    ++vertices_;
    if (flat) {
        home[at(v)] = p;
        rebuild(home);
        return true;
    }
    table_.set_vertex_bound(present_.size());
    attach(home, v, p, place, changed);
    return true;
}

template <int d>
void Mesh_embedding<d>::remove(std::span<const Coordinates<d>> home, Index v, std::vector<Cell_index>& changed) {
    builder_->order.note_going(v);
    if (detach(home, v, changed)) {
        present_[at(v)] = 0;
        --vertices_;
        return;
    }
    present_[at(v)] = 0;
    --vertices_;
    rebuild(home);
}

template <int d>
bool Mesh_embedding<d>::reinsert(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p, std::vector<Cell_index>& changed) {
    if (is_taken(home, p, v)) throw Error(Error_code::collision, "another vertex is at that position");
    if (!detach(home, v, changed)) return false;
    attach(home, v, p, locate(home, p, none), changed);
    keep_present(changed, 0);
    return true;
}

template <int d>
Relocation Mesh_embedding<d>::relocate(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) {
    if (is_taken(home, p, v)) return Relocation::refused;
    std::vector<Cell_index> changed;
    if (detach(home, v, changed)) {
        attach(home, v, p, locate(home, p, none), changed);
    } else {
        std::vector<Coordinates<d>> x(home.begin(), home.end());
        x[at(v)] = p;
        rebuild(x);
        home[at(v)] = p;
    }
    return Relocation::reinserted;
}

template <int d>
Relocation Mesh_embedding<d>::relocate_by_flips(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) {
    return update_in_place(home, v, p) ? Relocation::kept : relocate(home, v, p);
}

template <int d>
bool Mesh_embedding<d>::update_in_place(std::span<Coordinates<d>> home, Index v, const Coordinates<d>& p) {
    if (dimension_ != d) return false;
    const Coordinates<d> old = std::exchange(home[at(v)], p);
    const bool holds = star_holds<d>(table_, home, v);
    if (!holds) home[at(v)] = old;
    return holds;
}

template class Mesh_embedding<2>;
template class Mesh_embedding<3>;

}  // namespace annulus
