// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/engine/periodic_changes.h>

#include <annulus/space/basis_relation.h>
#include <annulus/space/nearest_shift.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr double most_factor = 64;  // a factor of an old vector in a new one

template <int d>
Shift<d> minus(Shift<d> l, const Shift<d>& r) {
    for (std::size_t i = 0; i < d; ++i) l[i] -= r[i];
    return l;
}

/// row times m.
template <int d, class T>
std::array<T, static_cast<std::size_t>(d)> product(const std::array<T, static_cast<std::size_t>(d)>& row,
                                                   const Integer_matrix<d>& m) {
    std::array<T, static_cast<std::size_t>(d)> out{};
    for (std::size_t j = 0; j < d; ++j)
        for (std::size_t i = 0; i < d; ++i) out[i] += row[j] * static_cast<T>(m[j][i]);
    return out;
}

/// How shifts between given points before a change are written after it.
template <int d>
class Renaming {
  public:
    Renaming(const Periodic_state<d>& before, const Periodic_state<d>& after) {
        const auto related = basis_relation<d>(after.lattice.box(), most_factor, [&](const Coordinates<d>& v) {
            return in_vectors<d>(before.lattice.box(), v);
        });
        if (!related) return;
        to_new_ = related->to_new;
        is_related_ = true;
        turns_.resize(std::max(before.place.size(), after.place.size()));
        for (std::size_t v = 0; v < std::min(before.place.size(), after.place.size()); ++v) {
            if (!is_place<d>(before.place[v]) || !is_place<d>(after.place[v])) continue;
            const Coordinates<d> from = product<d>(in_vectors<d>(before.lattice.box(), before.place[v]), to_new_);
            const Coordinates<d> to = in_vectors<d>(after.lattice.box(), after.place[v]);
            const Shift<d> old_image = product<d>(before.image[v], to_new_);
            Coordinates<d> way{};
            for (std::size_t i = 0; i < d; ++i)
                for (std::size_t k = 0; k < d; ++k) way[k] += (to[i] - from[i]) * after.lattice.box()[i][k];
            turns_[v] = nearest_shift<d>(after.lattice, way);
            for (std::size_t i = 0; i < d; ++i) turns_[v][i] += after.image[v][i] - old_image[i];
        }
    }
    [[nodiscard]] bool is_related() const { return is_related_; }
    /// Of `to` less that of `from`.
    [[nodiscard]] Shift<d> operator()(const Shift<d>& shift, Index from, Index to) const {
        Shift<d> s = product<d>(shift, to_new_);
        for (std::size_t i = 0; i < d; ++i)
            s[i] += turns_[static_cast<std::size_t>(from)][i] - turns_[static_cast<std::size_t>(to)][i];
        return s;
    }

  private:
    Integer_matrix<d> to_new_{};   // row j: old vector j as a combination of the new ones
    std::vector<Shift<d>> turns_;  // by vertex: its new position less the affine image of its old one, in boxes
    bool is_related_ = false;
};

/// An edge, and its name after the change.
template <int d>
struct Named_pair {
    Image_pair<d> name, pair;
    friend bool operator<(const Named_pair& l, const Named_pair& r) { return l.name < r.name; }
};

template <int d>
Image_pair<d> in_order(Image_pair<d> p) {
    const Shift<d> back = minus<d>({}, p.shift);
    return p.first < p.second || (p.first == p.second && back < p.shift) ? p : Image_pair<d>{p.second, p.first, back};
}

template <int d>
Shift<d> between(const Periodic_state<d>& state, std::size_t c, std::size_t a, std::size_t b) {
    return minus<d>(state.shift(state.table.image(c, b), true), state.shift(state.table.image(c, a), true));
}

/// The edges of these cells by name, each once.
template <int d, class Name>
std::vector<Named_pair<d>> edges_of(const Periodic_state<d>& state, const std::vector<std::size_t>& cells, Name name) {
    std::vector<Named_pair<d>> edges;
    for (const std::size_t c : cells)
        for (std::size_t a = 0; a <= d; ++a)
            for (std::size_t b = a + 1; b <= d; ++b) {
                const Image_pair<d> p{state.table.vertex[c][a], state.table.vertex[c][b], between(state, c, a, b)};
                edges.push_back({in_order<d>({p.first, p.second, name(p)}), in_order<d>(p)});
            }
    std::sort(edges.begin(), edges.end());
    const auto same = [](const auto& l, const auto& r) { return l.name == r.name; };
    edges.erase(std::unique(edges.begin(), edges.end(), same), edges.end());
    return edges;
}

/// The cell of these corners in its only form: an offset that is added to all of them changes neither order nor form.
template <int d>
Image_cell<d> in_order(const std::array<Index, static_cast<std::size_t>(d + 1)>& vertices,
                       const std::array<Shift<d>, static_cast<std::size_t>(d + 1)>& shifts) {
    constexpr std::size_t corners = d + 1;
    std::array<std::pair<Index, Shift<d>>, corners> at;
    for (std::size_t i = 0; i < corners; ++i) at[i] = {vertices[i], shifts[i]};
    bool is_odd = false;
    for (std::size_t i = 0; i < corners; ++i)
        for (std::size_t j = i + 1; j < corners; ++j) is_odd ^= at[j] < at[i];
    std::sort(at.begin(), at.end());
    if (is_odd) std::swap(at[d - 1], at[d]);
    Shift<d> lowest = at[0].second;
    for (const auto& [vertex, shift] : at)
        for (std::size_t k = 0; k < d; ++k) lowest[k] = std::min(lowest[k], shift[k]);
    Image_cell<d> cell;
    for (std::size_t i = 0; i < corners; ++i) {
        cell.vertices[i] = at[i].first;
        cell.offsets[i] = minus<d>(at[i].second, lowest);
    }
    return cell;
}

/// A cell, and its name after the change.
template <int d>
struct Named_cell {
    Image_cell<d> name, cell;
    friend bool operator<(const Named_cell& l, const Named_cell& r) { return l.name < r.name; }
};

/// These cells by name. `shift` names the offset of corner i of cell c from its corner 0.
template <int d, class Shift_of>
std::vector<Named_cell<d>> cells_of(const Periodic_state<d>& state, const std::vector<std::size_t>& cells,
                                    Shift_of shift) {
    std::vector<Named_cell<d>> named;
    for (const std::size_t c : cells) {
        std::array<Shift<d>, static_cast<std::size_t>(d + 1)> names{}, offsets{};
        for (std::size_t i = 1; i <= d; ++i) names[i] = shift(c, i), offsets[i] = between(state, c, 0, i);
        named.push_back({in_order<d>(state.table.vertex[c], names), in_order<d>(state.table.vertex[c], offsets)});
    }
    std::sort(named.begin(), named.end());
    return named;
}

/// Of those of `list` that `others` have not, what they are called before or after the change.
template <class Named, class Of>
auto without(const std::vector<Named>& list, const std::vector<Named>& others, bool is_related, Of of) {
    std::vector<std::decay_t<decltype(of(list.front()))>> rest;
    for (const Named& e : list)
        if (!is_related || !std::binary_search(others.begin(), others.end(), e)) rest.push_back(of(e));
    std::sort(rest.begin(), rest.end());
    return rest;
}

}  // namespace

template <int d>
Image_changes<d> periodic_changes(const Periodic_state<d>& before, const Periodic_state<d>& after) {
    const Renaming<d> renamed(before, after);
    const auto is_same = [&](std::size_t c) {
        if (c >= before.table.size() || c >= after.table.size() || !renamed.is_related() ||
            before.table.vertex[c] != after.table.vertex[c])
            return false;
        for (std::size_t i = 1; i <= d; ++i) {
            const auto& v = before.table.vertex[c];
            if (renamed(between(before, c, 0, i), v[0], v[i]) != between(after, c, 0, i)) return false;
        }
        return true;
    };
    std::vector<std::size_t> gone, came;
    for (std::size_t c = 0; c < std::max(before.table.size(), after.table.size()); ++c) {
        if (is_same(c)) continue;
        if (c < before.table.size()) gone.push_back(c);
        if (c < after.table.size()) came.push_back(c);
    }
    const bool is_related = renamed.is_related();
    const auto new_name = [&](const Shift<d>& shift, Index from, Index to) {
        return is_related ? renamed(shift, from, to) : shift;
    };
    const auto old_edges =
        edges_of(before, gone, [&](const Image_pair<d>& p) { return new_name(p.shift, p.first, p.second); });
    const auto new_edges = edges_of(after, came, [](const Image_pair<d>& p) { return p.shift; });
    const auto old_cells = cells_of(before, gone, [&](std::size_t c, std::size_t i) {
        const auto& v = before.table.vertex[c];
        return new_name(between(before, c, 0, i), v[0], v[i]);
    });
    const auto new_cells = cells_of(after, came, [&](std::size_t c, std::size_t i) { return between(after, c, 0, i); });
    const auto pair = [](const Named_pair<d>& e) { return e.pair; };
    const auto cell = [](const Named_cell<d>& e) { return e.cell; };
    return {without(new_edges, old_edges, is_related, pair), without(old_edges, new_edges, is_related, pair),
            without(new_cells, old_cells, is_related, cell), without(old_cells, new_cells, is_related, cell)};
}

template Image_changes<2> periodic_changes(const Periodic_state<2>&, const Periodic_state<2>&);
template Image_changes<3> periodic_changes(const Periodic_state<3>&, const Periodic_state<3>&);

}  // namespace annulus::inline v1
