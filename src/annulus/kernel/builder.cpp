// SPDX-License-Identifier: GPL-3.0-or-later
// Builder: insertion.
#include <annulus/kernel/builder.h>

#include <annulus/arithmetic/collision.h>
#include <annulus/certificate/bounds.h>
#include <annulus/certificate/exact_sign.h>
#include <annulus/kernel/spatial_order.h>
#include <annulus/mesh/degenerate.h>

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

namespace annulus {

namespace {

/// The other corners of slot i, before which a point takes the orientation that the cell has with the point in slot i.
template <int d>
constexpr auto facing() {
    if constexpr (d == 2) return std::array<std::array<std::uint8_t, 2>, 3>{{{1, 2}, {2, 0}, {0, 1}}};
    else return std::array<std::array<std::uint8_t, 3>, 4>{{{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}}};
}

template <int d>
constexpr std::uint32_t next_slot(std::uint32_t slot, std::uint32_t k) {
    return d == 3 ? (slot + k) & 3U : (slot + k) % 3U;
}

double determinant(const std::array<double, 2>& u, const std::array<double, 2>& v) { return u[0] * v[1] - u[1] * v[0]; }
double determinant(const std::array<double, 3>& u, const std::array<double, 3>& v, const std::array<double, 3>& w) {
    return ((u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1]) +
           (u[0] * v[1] - u[1] * v[0]) * w[2];
}

/// That of an orientation of differences up to m (bounds.h), and room for what underflows.
template <int d>
double orientation_bound(double m) {
    constexpr double least = 0x1p-1050;
    return (d == 2 ? bounds::orientation_2 * (m * m) : bounds::orientation_3 * (m * m * m)) * bounds::u + least;
}

}  // namespace

template <int d>
bool Builder<d>::build(std::span<const Coordinates<d>> x, std::vector<Index> vertices) {
    order_ = std::move(vertices);
    spatial_order<d>(x, order_);
    take_positions(x);
    used_ = count_ = 0;
    std::array<Rank, corners> simplex;
    if (!find_simplex(simplex)) return false;
    first_cells(simplex);
    Cell last = 0;
    for (Rank v = 0; v < infinity_; ++v) {
        if (std::find(simplex.begin(), simplex.end(), v) != simplex.end()) continue;
        Rank taken = infinity_;
        const Cell first = locate(at(v), last, taken);
        if (first == no_cell)
            throw collision_of("points", "have", order_[static_cast<std::size_t>(taken)],
                               order_[static_cast<std::size_t>(v)]);
        insert(v, first);
        last = cavity_.cells[cavity_.facets_size - 1];
    }
    number_cells();
    return true;
}

template <int d>
auto Builder<d>::locate(const Coordinates<d>& q, Cell start, Rank& taken) const -> Cell {
    constexpr auto others = facing<d>();
    Cell c = start;
    if (const int i = slot_of_infinity(cells_[c]); i >= 0) c = cells_[c].across[static_cast<std::size_t>(i)] >> 2;
    std::uint32_t from = corners;  // the slot across which it came
    for (std::uint32_t steps = 0;; ++steps) {
        const Cell_data& cell = cells_[c];
        // Most walks end here, and those that leave the hull where they are strictly beyond a facet of it.
        if (cell.sphere.at(Lifted<d>(q, at(cell.vertex[0])).from, bound_[c]).inside() || slot_of_infinity(cell) >= 0)
            return c;
        std::array<std::array<double, static_cast<std::size_t>(d)>, corners> to;
        double m = 0;
        for (std::size_t i = 0; i <= d; ++i) {
            const Lifted<d> l(at(cell.vertex[i]), q);
            to[i] = l.from;
            m = std::max(m, l.magnitude());
        }
        const double bound = orientation_bound<d>(m);
        bool left = false;
        for (std::uint32_t k = 0; k <= d && !left; ++k) {
            const std::uint32_t i = next_slot<d>(steps % corners, k);
            if (i == from) continue;
            const double side = std::apply([&](auto... o) { return determinant(to[o]...); }, others[i]);
            if (side < -bound) {
                left = true;
            } else if (!(side > bound)) {
                Tuple<d, d + 1> x;
                for (std::size_t j = 0; j <= d; ++j) x[j] = j == i ? &q : &at(cell.vertex[j]);
                left = exact_orientation_sign(x).sign < 0;
            }
            if (left) {
                from = cell.across[i] & 3U;
                c = cell.across[i] >> 2;
            }
        }
        if (left) continue;
        for (const Rank v : cell.vertex)
            if (at(v) == q) return taken = v, no_cell;
        return c;
    }
}

/// The sphere of a cell at infinity is the half-space beyond its facet and, in the plane of the facet, the circle that
/// its finite neighbour cuts there.
template <int d>
bool Builder<d>::holds_exactly(Cell c, Rank v) const {
    if (const int i = slot_of_infinity(cells_[c]); i >= 0) {
        std::array<Scaled_point<d>, corners> p;
        Tuple<d, d + 1> x;
        for (std::size_t j = 0; j <= d; ++j) {
            p[j] = on_grid(static_cast<int>(j) == i ? v : cells_[c].vertex[j]);
            x[j] = p[j].x;
        }
        const std::optional<int> told = integer_orientation<d>(p);
        const int side = told ? *told : exact_orientation_sign(x).sign;
        if (side != 0) return side > 0;
        c = cells_[c].across[static_cast<std::size_t>(i)] >> 2;
        const auto value = cells_[c].sphere.at(Lifted<d>(at(v), at(cells_[c].vertex[0])).from, std::fabs(bound_[c]));
        if (value.certain()) return value.inside();
    }
    std::array<Scaled_point<d>, corners + 1> p;
    for (std::size_t j = 0; j <= d; ++j) p[j] = on_grid(cells_[c].vertex[j]);
    p[d + 1] = on_grid(v);
    if (const std::optional<bool> told = integer_sphere_holds<d>(p)) return *told;
    Tuple<d, d + 1> x;
    for (std::size_t j = 0; j <= d; ++j) x[j] = p[j].x;
    return sphere_holds_exactly<d>(x, at(v));
}

template <int d>
void Builder<d>::insert(Rank v, Cell first) {
    find_cavity(v, first);
    take_cells();
    read_border();
    fill(v);
}

/// Cells and facets of its border are written down whether they belong there or not, and counted if they do: a branch
/// would be mispredicted every other time.
template <int d>
void Builder<d>::find_cavity(Rank v, Cell first) {
    const Coordinates<d> q = at(v);
    constexpr std::size_t room = 8;
    Cavity& cavity = cavity_;
    if (cavity.entered.size() < room) cavity.entered.resize(64);
    if (cavity.border.size() < room) cavity.border.resize(64);
    std::size_t cells = 1, facets = 0;
    const auto look = [&](Half_facet h) {
        const Half_facet t = cells_[h >> 2].across[h & 3U];
        const Cell c = t >> 2;
        const float constant = bound_[c];
        const auto value = cells_[c].sphere.at(Lifted<d>(q, at(cells_[c].vertex[0])).from, constant);
        bool holds = value.inside();
        const bool met = std::signbit(constant);
        if (!value.certain() && !met) [[unlikely]]
            holds = holds_exactly(c, v);
        const bool comes = holds && !met;
        cavity.entered[cells] = t;
        cells += std::size_t{comes};
        cavity.border[facets] = h;
        facets += std::size_t{!holds && !met};
        bound_[c] = comes ? -constant : constant;
    };
    cavity.entered[0] = 4 * first;
    bound_[first] = -bound_[first];
    for (std::uint32_t i = 0; i <= d; ++i) look(4 * first + i);
    for (std::size_t k = 1; k < cells; ++k) {
        const Half_facet h = cavity.entered[k];
        if (cells + room > cavity.entered.size()) cavity.entered.resize(2 * cavity.entered.size());
        if (facets + room > cavity.border.size()) cavity.border.resize(2 * cavity.border.size());
        for (std::uint32_t i = 1; i <= d; ++i) look((h & ~3U) | next_slot<d>(h & 3U, i));
    }
    cavity.size = cells;
    cavity.facets_size = facets;
}

/// A cell for each facet: first those of the cavity. What is too many of these is free.
template <int d>
void Builder<d>::take_cells() {
    Cavity& cavity = cavity_;
    const std::size_t count = std::max(cavity.size, cavity.facets_size);
    if (cavity.cells.size() < count) cavity.cells.resize(2 * count);
    for (std::size_t k = 0; k < cavity.size; ++k) cavity.cells[k] = cavity.entered[k] >> 2;
    for (std::size_t k = cavity.size; k < cavity.facets_size; ++k) {
        if (free_.empty()) {
            cavity.cells[k] = static_cast<Cell>(used_++);
        } else {
            cavity.cells[k] = free_.back();
            free_.pop_back();
        }
    }
    free_.insert(free_.end(), cavity.cells.begin() + static_cast<std::ptrdiff_t>(cavity.facets_size),
                 cavity.cells.begin() + static_cast<std::ptrdiff_t>(count));
    if (used_ > bound_.size()) {
        if (used_ > static_cast<std::size_t>(Horizons::cells)) throw_too_large();
        grow_cells(used_ + used_ / 2);
    }
}

/// Before its cells are written over.
template <int d>
void Builder<d>::read_border() {
    constexpr auto others = facing<d>();
    Cavity& cavity = cavity_;
    if (cavity.facets.size() < cavity.facets_size) cavity.facets.resize(2 * cavity.facets_size);
    for (std::size_t f = 0; f < cavity.facets_size; ++f) {
        const Half_facet h = cavity.border[f];
        const Cell_data& cell = cells_[h >> 2];
        for (std::size_t k = 0; k < d; ++k) cavity.facets[f].vertex[k] = cell.vertex[others[h & 3U][k]];
        cavity.facets[f].beyond = cell.across[h & 3U];
    }
}

template <int d>
void Builder<d>::fill(Rank v) {
    const std::span<const Facet> facets(cavity_.facets.data(), cavity_.facets_size);
    const std::span<const Cell> cells(cavity_.cells.data(), cavity_.facets_size);
    const Coordinates<d>& p = at(v);
    for (std::size_t f = 0; f < facets.size(); ++f) {
        Cell_data& cell = cells_[cells[f]];
        cell.vertex[0] = v;
        std::copy(facets[f].vertex.begin(), facets[f].vertex.end(), cell.vertex.begin() + 1);
        cell.across[0] = facets[f].beyond;
        cells_[facets[f].beyond >> 2].across[facets[f].beyond & 3U] = 4 * cells[f];
    }
    ridges_.glue(facets, cells, [this](Half_facet h, Half_facet t) { cells_[h >> 2].across[h & 3U] = t; });
    for (std::size_t f = 0; f < facets.size(); ++f)
        cells_[cells[f]].sphere =
            std::apply([&](auto... w) { return kept_sphere(lifted(w, p)..., bound_[cells[f]]); }, facets[f].vertex);
}

template class Builder<2>;
template class Builder<3>;

}  // namespace annulus
