// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/periodic_motion.h>

#include <annulus/space/basis_relation.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace annulus::inline v1 {

namespace {

constexpr double most_basis_change = 8;  // a factor of an old basis vector in a new one

template <int d>
Offset<d> offset_of(const Coordinates<d>& whole) {
    Shift<d> o;
    for (std::size_t j = 0; j < d; ++j) o[j] = static_cast<std::int32_t>(whole[j]);
    return Offset<d>(o);
}

/// Adds an offset to each corner of a cell, by its vertex, and restores the normal form.
template <int d>
bool relabel(Periodic_table<d>& table, std::size_t c, const std::vector<Offset<d>>& more) {
    bool same = true;
    for (const Index v : table.vertex[c]) same = same && more[static_cast<std::size_t>(v)].is_zero();
    if (same) return true;
    for (std::size_t i = 0; i <= d; ++i)
        table.offset[c][i] = table.offset[c][i] + more[static_cast<std::size_t>(table.vertex[c][i])];
    return normalise<d>(table.offset[c]);
}

/// A way whose coordinates are at most these in magnitude is by less than half of each basis vector.
template <int d>
Coordinates<d> short_way(const Lattice<d>& lattice) {
    Coordinates<d> most;
    for (std::size_t i = 0; i < d; ++i) {
        Coordinates<d> unit{};
        unit[i] = 1;
        double largest = 0;
        for (const double c : lattice.in_basis(unit)) largest = std::max(largest, std::fabs(c));
        most[i] = 0.49 / (d * largest);
    }
    return most;
}

}  // namespace

template <int d>
bool Periodic_motion<d>::relate(const Lattice<d>& from, const Lattice<d>& to) {
    const auto related =
        basis_relation<d>(to.basis(), most_basis_change, [&](const Coordinates<d>& v) { return from.in_basis(v); });
    if (!related || related->determinant != 1) return false;
    basis_.to_new = related->to_new;
    basis_.differs = false;
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) basis_.differs = basis_.differs || basis_.to_new[j][i] != (i == j ? 1 : 0);
    return true;
}

/// The affine image, rounded to the grid and brought into the cell of the lattice.
template <int d>
void Periodic_motion<d>::find_home(const Periodic_points<d>& from, const Lattice<d>& to) {
    const std::size_t n = from.place.size();
    mapped_.place.resize(n);
    mapped_.growth.resize(n);
    const auto& basis = to.basis();
    const auto& grid = to.grid();
    for (std::size_t v = 0; v < n; ++v) {
        if (!is_place<d>(from.place[v])) {  // no vertex
            mapped_.place[v] = from.place[v];
            mapped_.growth[v] = {};
            continue;
        }
        const Coordinates<d> f = from.lattice.in_basis(from.place[v]);
        Coordinates<d> g{}, out{};
        for (std::size_t j = 0; j < d; ++j) {
            for (std::size_t i = 0; i < d; ++i) g[j] += f[i] * static_cast<double>(basis_.to_new[i][j]);
            if (g[j] < -0.5 || g[j] >= 1.5) out[j] = std::floor(g[j]);
            g[j] -= out[j];
        }
        for (std::size_t i = 0; i < d; ++i) {
            double x = 0;
            for (std::size_t j = 0; j < d; ++j) x += g[j] * basis[j][i];
            mapped_.place[v][i] = std::nearbyint(x / grid[i]) * grid[i];
        }
        mapped_.growth[v] = offset_of<d>(out);
        mapped_.wraps = mapped_.wraps || !mapped_.growth[v].is_zero();
    }
    home_ = mapped_.place;
}

/// The goal is the new place, so far.
template <int d>
void Periodic_motion<d>::find_goal(std::size_t v, const Lattice<d>& to) {
    Coordinates<d> way;
    for (std::size_t i = 0; i < d; ++i) way[i] = home_[v][i] - goal_[v][i];
    way = to.in_basis(way);
    for (double& c : way) c = std::nearbyint(c);
    const Offset<d> o = offset_of<d>(way);
    if (o.is_zero()) return;
    wrapped_.push_back(static_cast<Index>(v));
    to_goal_[v] = o;
    goal_[v] = to.place(goal_[v], o);
}

template <int d>
bool Periodic_motion<d>::begin(const Periodic_points<d>& from, const Periodic_points<d>& to) {
    if (!relate(from.lattice, to.lattice)) return false;
    const std::size_t n = from.place.size();
    if (to_goal_.size() != n) to_goal_.assign(n, {});
    else
        for (const Index v : wrapped_) to_goal_[static_cast<std::size_t>(v)] = {};
    wrapped_.clear();
    mapped_.wraps = false;
    moves_ = from.lattice.basis() != to.lattice.basis();
    if (moves_) find_home(from, to.lattice);
    else home_ = from.place;
    goal_.resize(n);
    const Coordinates<d> most = short_way(to.lattice);
    for (std::size_t v = 0; v < n; ++v) {
        unsigned moves = 0, far = 0;
        for (std::size_t i = 0; i < d; ++i) {
            const double way = home_[v][i] - to.place[v][i];  // NaN at free indices, which do not move
            moves |= std::fabs(way) > 0 ? 1U : 0U;
            far |= std::fabs(way) > most[i] ? 1U : 0U;
            goal_[v][i] = to.place[v][i];
        }
        moves_ = moves_ || moves != 0;
        if (far != 0) find_goal(v, to.lattice);
    }
    return true;
}

/// False where the result is too large to be one.
template <int d>
bool Periodic_motion<d>::transform(Offset<d>& o) const {
    const Shift<d> old = o.unpacked();
    Shift<d> s{};
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) s[j] += old[i] * static_cast<std::int32_t>(basis_.to_new[i][j]);
    constexpr std::int32_t room = 16;  // for what is added by vertices
    for (const std::int32_t c : s)
        if (c <= room - Offset<d>::limit || c >= Offset<d>::limit - room) return false;
    o = Offset<d>(s);
    return true;
}

template <int d>
bool Periodic_motion<d>::relabel_home(Periodic_table<d>& table) const {
    if (!basis_.differs) {
        bool small = true;
        for (std::size_t c = 0; mapped_.wraps && c < table.size(); ++c)
            small = relabel(table, c, mapped_.growth) && small;
        return small;
    }
    for (std::size_t c = 0; c < table.size(); ++c) {
        for (std::size_t i = 0; i <= d; ++i) {
            Offset<d>& o = table.offset[c][i];
            if (!transform(o)) return false;
            o = o + mapped_.growth[static_cast<std::size_t>(table.vertex[c][i])];
        }
        if (!normalise<d>(table.offset[c])) return false;
    }
    return true;
}

template <int d>
bool Periodic_motion<d>::relabel_goal(Periodic_table<d>& table, std::span<const std::size_t> cells) const {
    bool small = true;
    for (const std::size_t c : cells) small = relabel(table, c, to_goal_) && small;
    return small;
}

template class Periodic_motion<2>;
template class Periodic_motion<3>;

}  // namespace annulus::inline v1
