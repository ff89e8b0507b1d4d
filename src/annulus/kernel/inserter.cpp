// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/inserter.h>

#include <annulus/arithmetic/limits.h>
#include <annulus/error.h>
#include <annulus/mesh/degenerate.h>
#include <annulus/predicate/bounds.h>
#include <annulus/predicate/exact_sign.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>

namespace annulus::inline v1 {

namespace {

double determinant(const std::array<double, 2>& u, const std::array<double, 2>& v) { return u[0] * v[1] - u[1] * v[0]; }
double determinant(const std::array<double, 3>& u, const std::array<double, 3>& v, const std::array<double, 3>& w) {
    return ((u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1]) +
           (u[0] * v[1] - u[1] * v[0]) * w[2];
}

/// The error bound of an orientation of differences up to m (bounds.h), with room for underflow.
template <int d>
double orientation_bound(double m) {
    constexpr double least = 0x1p-1050;
    return (d == 2 ? bounds::orientation_2 * (m * m) : bounds::orientation_3 * (m * m * m)) * bounds::u + least;
}

}  // namespace

template <int d>
template <bool shared>
auto Inserter<d>::insert_in(Rank v) -> Outcome {
    const Cell first = locate<shared>(cells_->at(v), last_);
    if (first == Cells::no_cell) return blocker_ != cells_->infinity ? Outcome::taken : Outcome::lost;
    if (!find_cavity<shared>(v, first) || !take_cells<shared>()) return Outcome::postponed;
    fill(v);
    last_ = cavity_.cells[cavity_.border_size - 1];
    if constexpr (shared) leave_infinity();
    else last_ = nearest_new_cell(v, std::min(v + 1, cells_->infinity - 1));
    return Outcome::inserted;
}

template <int d>
bool Inserter<d>::insert(Rank v) {
    return insert_in<false>(v) == Outcome::inserted;
}

template <int d>
auto Inserter<d>::insert_in_partition(Rank v) -> Outcome {
    return insert_in<true>(v);
}

/// Of the cells around v, which was inserted last, one whose sphere holds `next`, if there is one: most walks end where
/// they begin. Their spheres are relative to v, so one costs three or four multiplications.
template <int d>
auto Inserter<d>::nearest_new_cell(Rank v, Rank next) const -> Cell {
    const std::array<double, static_cast<std::size_t>(d)> from =
        Euclidean<d>::difference(cells_->at(next), cells_->at(v));
    double least = 0;
    Cell best = cavity_.cells[cavity_.border_size - 1];
    for (std::size_t f = 0; f < cavity_.border_size; ++f) {
        const Cell c = cavity_.cells[f];
        const double value = cells_->cells[c].sphere.at(from, 0).value;
        const bool less = value < least;
        least = std::min(least, value);
        best ^= (best ^ c) & (0U - std::uint32_t{less});
    }
    return best;
}

/// Moves last_ to a finite new cell, if there is one: beyond an infinite cell the partition may end.
template <int d>
void Inserter<d>::leave_infinity() {
    for (std::size_t f = cavity_.border_size; f-- > 0;) {
        last_ = cavity_.cells[f];
        if (cells_->slot_of_infinity(cells_->cells[last_]) < 0) return;
    }
}

template <int d>
void Inserter<d>::start_in(const Thread_partition& partition, const Inserter& from) {
    cells_ = from.cells_;
    partition_ = partition;
    free_.clear();
    last_ = from.last_;
    ridges_.begin(static_cast<std::size_t>(cells_->infinity) + 1);
}

template <int d>
auto Inserter<d>::start_near(Rank v) -> Cell {
    const Cell c = locate<false>(cells_->at(v), last_);
    if (c == Cells::no_cell) return c;
    last_ = c;
    const auto& cell = cells_->cells[c];
    return cells_->slot_of_infinity(cell) < 0 && partition_.has(c) ? c : Cells::no_cell;
}

template <int d>
template <bool shared>
auto Inserter<d>::locate(const Coordinates<d>& q, Cell start) -> Cell {
    static constexpr auto others = facing<d>();
    const Cells& g = *cells_;
    Cell c = start;
    blocker_ = g.infinity;
    if (const int i = g.slot_of_infinity(g.cells[c]); i >= 0) c = g.cells[c].across[static_cast<std::size_t>(i)] >> 2;
    std::uint32_t from = corners;  // the slot across which the walk came
    for (std::uint32_t steps = 0;; ++steps) {
        const auto& cell = g.cells[c];
        if (shared && !partition_.has(c)) return Cells::no_cell;
        // If the vertex is postponed the next walk starts here, not where the last vertex was inserted.
        if (shared && g.slot_of_infinity(cell) < 0) last_ = c;
        // Most walks end here. Walks that leave the hull end here when they are strictly beyond one of its facets.
        if (cell.sphere.at(Lifted<d>(q, g.at(cell.vertex[0])).from, g.bound(c)).inside() ||
            g.slot_of_infinity(cell) >= 0)
            return c;
        std::array<std::array<double, static_cast<std::size_t>(d)>, corners> to;
        double m = 0;
        for (std::size_t i = 0; i <= d; ++i) {
            const Lifted<d> l(g.at(cell.vertex[i]), q);
            to[i] = l.from;
            m = std::max(m, l.magnitude());
        }
        const double bound = orientation_bound<d>(m);
        bool left = false;
        for (std::uint32_t k = 0, i = steps % corners; k <= d && !left; ++k, i = next_slot<d>(i, 1)) {
            if (i == from) continue;
            const double side = std::apply([&](auto... o) { return determinant(to[o]...); }, others[i]);
            if (side < -bound) {
                left = true;
            } else if (!(side > bound)) {
                Tuple<d, d + 1> x;
                for (std::size_t j = 0; j <= d; ++j) x[j] = j == i ? &q : &g.at(cell.vertex[j]);
                left = exact_orientation_sign(x).sign < 0;
            }
            if (left) {
                from = cell.across[i] & 3U;
                c = cell.across[i] >> 2;
            }
        }
        if (left) continue;
        for (const Rank v : cell.vertex)
            if (g.at(v) == q) return blocker_ = v, Cells::no_cell;
        return c;
    }
}

/// The sphere of an infinite cell is the half-space beyond its facet and, in the plane of the facet, the disc that the
/// sphere of its finite neighbour cuts out.
template <int d>
bool Inserter<d>::holds_exactly(Cell c, Rank v) const {
    const Cells& g = *cells_;
    if (const int i = g.slot_of_infinity(g.cells[c]); i >= 0) {
        std::array<Scaled_point<d>, corners> p;
        Tuple<d, d + 1> x;
        for (std::size_t j = 0; j <= d; ++j) {
            p[j] = g.on_grid(static_cast<int>(j) == i ? v : g.cells[c].vertex[j]);
            x[j] = p[j].x;
        }
        const std::optional<int> decided = integer_orientation<d>(p);
        const int side = decided ? *decided : exact_orientation_sign(x).sign;
        if (side != 0) return side > 0;
        c = g.cells[c].across[static_cast<std::size_t>(i)] >> 2;
        const auto value = g.look(c, g.at(v));
        if (value.certain()) return value.inside();
    }
    std::array<Scaled_point<d>, corners + 1> p;
    for (std::size_t j = 0; j <= d; ++j) p[j] = g.on_grid(g.cells[c].vertex[j]);
    p[d + 1] = g.on_grid(v);
    if (const std::optional<bool> decided = integer_sphere_holds<d>(p)) return *decided;
    Tuple<d, d + 1> x;
    for (std::size_t j = 0; j <= d; ++j) x[j] = p[j].x;
    return sphere_holds_exactly<d>(x, g.at(v));
}

/// Takes a cell for each facet, those of the cavity first. Cells that are left over become free.
template <int d>
template <bool shared>
bool Inserter<d>::take_cells() {
    Cavity& cavity = cavity_;
    const std::size_t count = std::max(cavity.size, cavity.border_size);
    if constexpr (shared)
        while (free_.size() + cavity.size < cavity.border_size)
            if (!claim_block()) return unmark(), false;
    if (cavity.cells.size() < count) cavity.cells.resize(2 * count);
    for (std::size_t k = cavity.size; k < cavity.border_size; ++k) {
        if (free_.empty()) {
            cavity.cells[k] = static_cast<Cell>(cells_->used++);
        } else {
            cavity.cells[k] = free_.back();
            free_.pop_back();
        }
    }
    free_.insert(free_.end(), cavity.cells.begin() + static_cast<std::ptrdiff_t>(cavity.border_size),
                 cavity.cells.begin() + static_cast<std::ptrdiff_t>(count));
    if (!shared && cells_->used > cells_->room()) {
        if (cells_->used > static_cast<std::size_t>(Limits::cells))
            throw Error(Error_code::too_large, "more than " + std::to_string(Limits::cells) + " cells");
        cells_->make_room(cells_->used + cells_->used / 2);
    }
    return true;
}

/// Claims unused cells for this thread.
template <int d>
bool Inserter<d>::claim_block() {
    constexpr std::size_t block = 1024;
    const std::size_t first = partition_.unused->fetch_add(block, std::memory_order_relaxed);
    const std::size_t last = std::min(first + block, cells_->room());
    for (std::size_t c = last; c-- > first;) {
        cells_->bound(static_cast<Cell>(c)) = -1;
        partition_.owner[c] = partition_.own;
        free_.push_back(static_cast<Cell>(c));
    }
    return first < last;
}

template class Inserter<2>;
template class Inserter<3>;

}  // namespace annulus::inline v1
