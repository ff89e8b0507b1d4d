// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/delaunay_mesh.h>

#include <annulus/error.h>
#include <annulus/kernel/builder.h>
#include <annulus/mesh/insert_vertex.h>
#include <annulus/mesh/replace_cells.h>
#include <annulus/mesh/walk.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <stdexcept>
#include <utility>

namespace annulus::inline v1 {

template <int d>
Delaunay_mesh<d>::Delaunay_mesh() = default;

template <int d>
Delaunay_mesh<d>::~Delaunay_mesh() = default;

template <int d>
void Delaunay_mesh<d>::end_step() noexcept {
    builder_.end_step();
}

template <int d>
void Delaunay_mesh<d>::build(std::span<const Coordinates<d>> x, std::span<const Index> free) {
    vertices_.assign(x.size());
    for (const Index v : free) vertices_.erase(v);
    rebuild(x);
    builder_.release();  // some meshes are never rebuilt
}

template <int d>
void Delaunay_mesh<d>::rebuild(std::span<const Coordinates<d>> x) {
    Builder<d>& builder = builder_.get();
    if (builder.build(x, vertices_.list(), threads_)) {
        builder.copy_to(table_, x.size(), threads_);
        basis_.clear();
        dimension_ = d;
        return;
    }
    require_distinct<d>(x, vertices_.list());
    table_.reserve(x.size(), 0);
    table_.clear(x.size());
    find_basis(x);
}

/// Whether p is outside the affine hull of the vertices, which is not the whole space.
template <int d>
bool Delaunay_mesh<d>::spans_more(std::span<const Coordinates<d>> positions, const Coordinates<d>& p) const {
    std::array<const Coordinates<d>*, static_cast<std::size_t>(d)> independent{};
    for (std::size_t k = 0; k < basis_.size(); ++k) independent[k] = &positions[at(basis_[k])];
    return annulus::spans_more<d>(std::span(independent).first(basis_.size()), p);
}

/// Finds a basis and the dimension. Precondition: the dimension is less than d.
template <int d>
void Delaunay_mesh<d>::find_basis(std::span<const Coordinates<d>> x) {
    basis_.clear();
    basis_.reserve(static_cast<std::size_t>(d));
    for (std::size_t v = 0; v < vertices_.bound(); ++v)
        if (has(static_cast<Index>(v)) && spans_more(x, x[v])) basis_.push_back(static_cast<Index>(v));
    dimension_ = static_cast<int>(basis_.size()) - 1;
}

template <int d>
void Delaunay_mesh<d>::restore(std::span<const Coordinates<d>> x, Index fresh) {
    if (fresh != none && at(fresh) < vertices_.bound() && has(fresh)) vertices_.erase(fresh);
    vertices_.set_bound(x.size());
    rebuild(x);
}

template <int d>
void Delaunay_mesh<d>::clear_cells() noexcept {
    table_.clear(0);
    basis_.clear();
    dimension_ = -1;
}

/// Rebuilds all cells under other indices, all of which `made` receives. The table does not become smaller, since the
/// engine may have recorded some indices.
template <int d>
void Delaunay_mesh<d>::replace_everything(std::span<const Coordinates<d>> x, std::vector<Cell_index>& made) {
    Builder<d>& builder = builder_.get();
    if (!builder.build(x, vertices_.list())) throw std::logic_error("points that had cells are flat");
    std::vector<Cell_sites<d>> cells;
    builder.for_each_cell([&cells](std::uint32_t, const Cell_sites<d>& cell, const auto&) { cells.push_back(cell); });
    std::vector<Cell_index> old;
    for (const Cell_index c : table_.cells()) old.push_back(c);
    replace_cells<d>(table_, old, cells, made);
}

/// Keeps of the entries from `first` on those that are cells, each once.
template <int d>
void Delaunay_mesh<d>::keep_present(std::vector<Cell_index>& cells, std::size_t first) const {
    const auto begin = cells.begin() + static_cast<std::ptrdiff_t>(first);
    std::sort(begin, cells.end());
    const auto gone = [this](Cell_index c) { return !table_.is_cell(c); };
    cells.erase(std::remove_if(begin, std::unique(begin, cells.end()), gone), cells.end());
}

/// The cells outside are Delaunay at `positions`, and so were the changed ones before the call.
template <int d>
void Delaunay_mesh<d>::restore_cells(std::span<const Coordinates<d>> positions, std::span<const Cell_index> cells,
                                     std::vector<Cell_index>& made) {
    std::vector<Cell_index> present;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(present),
                 [this](Cell_index c) { return table_.is_cell(c); });
    const std::size_t first = made.size();
    if (!local_.rebuild(positions, present, everything(), made)) {
        replace_everything(positions, made);
    }
    keep_present(made, first);
}

template <int d>
Cell_index Delaunay_mesh<d>::locate(std::span<const Coordinates<d>> positions, const Coordinates<d>& p, Index own) {
    const auto is_present = [this](Index v) { return has(v) && table_.corner_of(v) != no_corner; };
    const Index near = landmarks_.near(positions, vertices_.bound(), p, own, is_present);
    std::size_t steps = 0;
    const Corner_index start = near != none ? table_.corner_of(near) : table_.corner_of_infinity();
    const Cell_index c = walk_to<d>(Table_walker<d>(table_, positions), p, table_.cell_of(start), steps);
    landmarks_.note(Landmarks<d>::nearest(positions, cell_vertices(table_, c), p, own), steps);
    return c;
}

template <int d>
bool Delaunay_mesh<d>::is_taken(std::span<const Coordinates<d>> positions, const Coordinates<d>& p, Index but) {
    if (dimension_ < d) {
        for (std::size_t v = 0; v < vertices_.bound(); ++v)
            if (has(static_cast<Index>(v)) && static_cast<Index>(v) != but && positions[v] == p) return true;
        return false;
    }
    return is_at_corner(positions, p, locate(positions, p, but), but);
}

/// Whether a vertex of c other than `but` is at p.
template <int d>
bool Delaunay_mesh<d>::is_at_corner(std::span<const Coordinates<d>> positions, const Coordinates<d>& p, Cell_index c,
                                    Index but) const {
    const auto vertices = cell_vertices(table_, c);
    const auto is_there = [&](Index v) { return v != infinite && v != but && positions[at(v)] == p; };
    return std::any_of(vertices.begin(), vertices.end(), is_there);
}

/// Inserts v at p, where there is no vertex, in the cell `place`.
template <int d>
void Delaunay_mesh<d>::attach(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p, Cell_index place,
                              std::vector<Cell_index>& changed) {
    const Coordinates<d> old = std::exchange(positions[at(v)], p);
    const std::size_t first = changed.size();
    try {
        insert_vertex<d>(table_, positions, place, v, changed);
    } catch (...) {
        positions[at(v)] = old;
        throw;
    }
    keep_present(changed, first);
}

/// Returns false, with nothing changed, when the remaining vertices would be flat.
template <int d>
bool Delaunay_mesh<d>::detach(std::span<const Coordinates<d>> positions, Index v, std::vector<Cell_index>& changed) {
    if (dimension_ != d || vertices() <= d + 1U) return false;
    std::vector<Cell_index> star;
    table_.for_each_corner(v, [&](Corner_index h) { star.push_back(table_.cell_of(h)); });
    const std::size_t first = changed.size();
    if (!local_.remove(positions, star, v, everything(), changed)) return false;
    keep_present(changed, first);
    table_.set_absent(v);
    return true;
}

template <int d>
bool Delaunay_mesh<d>::insert(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p,
                              std::vector<Cell_index>& changed) {
    const bool flat = dimension_ < d;
    const Cell_index place = flat ? no_cell : locate(positions, p, none);
    if (flat ? is_taken(positions, p, none) : is_at_corner(positions, p, place, none)) return false;
    vertices_.insert(v);
    if (flat) {
        positions[at(v)] = p;
        insert_flat(positions, v);
        return true;
    }
    table_.set_vertex_bound(vertices_.bound());
    attach(positions, v, p, place, changed);
    return true;
}

/// There are no cells to change unless v spans the space together with the others.
template <int d>
void Delaunay_mesh<d>::insert_flat(std::span<const Coordinates<d>> positions, Index v) {
    if (spans_more(positions, positions[at(v)])) {
        if (dimension_ + 1 == d) return rebuild(positions);
        basis_.push_back(v);
        ++dimension_;
    }
    table_.set_vertex_bound(vertices_.bound());
}

template <int d>
void Delaunay_mesh<d>::remove(std::span<const Coordinates<d>> positions, Index v, std::vector<Cell_index>& changed) {
    const bool detached = detach(positions, v, changed);
    vertices_.erase(v);
    if (detached) return;
    if (dimension_ == d) rebuild(positions);
    else if (std::find(basis_.begin(), basis_.end(), v) != basis_.end()) find_basis(positions);
}

template <int d>
bool Delaunay_mesh<d>::reinsert(std::span<Coordinates<d>> positions, Index v, const Coordinates<d>& p,
                                std::vector<Cell_index>& changed) {
    if (is_taken(positions, p, v)) throw Error(Error_code::duplicate_point, "another vertex is at that position");
    if (!detach(positions, v, changed)) return false;
    attach(positions, v, p, locate(positions, p, none), changed);
    keep_present(changed, 0);
    return true;
}

template class Delaunay_mesh<2>;
template class Delaunay_mesh<3>;

}  // namespace annulus::inline v1
