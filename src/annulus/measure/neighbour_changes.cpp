// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/neighbour_changes.h>

#include <algorithm>
#include <iterator>

namespace annulus::inline v1 {

template <int d>
Vertex_pairs edges_of_cells(std::span<const Index> cells) {
    Vertex_pairs edges;
    for (std::size_t c = 0; c < cells.size(); c += d + 1)
        for (std::size_t i = c; i <= c + d; ++i)
            for (std::size_t k = c; k < i; ++k)
                if (cells[i] >= 0 && cells[k] >= 0)  // neither infinity nor padding
                    edges.emplace_back(std::min(cells[i], cells[k]), std::max(cells[i], cells[k]));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

template <int d>
Edge_changes edge_changes(std::span<const Index> came, std::span<const Index> gone) {
    const Vertex_pairs now = edges_of_cells<d>(came);
    const Vertex_pairs before = edges_of_cells<d>(gone);
    Edge_changes out;
    std::set_difference(now.begin(), now.end(), before.begin(), before.end(), std::back_inserter(out.made));
    std::set_difference(before.begin(), before.end(), now.begin(), now.end(), std::back_inserter(out.broken));
    return out;
}

template Vertex_pairs edges_of_cells<2>(std::span<const Index>);
template Vertex_pairs edges_of_cells<3>(std::span<const Index>);
template Edge_changes edge_changes<2>(std::span<const Index>, std::span<const Index>);
template Edge_changes edge_changes<3>(std::span<const Index>, std::span<const Index>);

template <int d>
void Neighbour_changes<d>::name(Index v, std::uint64_t id) {
    const auto at = static_cast<std::size_t>(v);
    if (at >= id_.size()) id_.resize(at + 1);
    id_[at] = id;
}

template <int d>
void Neighbour_changes<d>::enter(const Vertex_pairs& edges, int sign) {
    for (const auto& [v, w] : edges) {
        const std::uint64_t a = id_[static_cast<std::size_t>(v)];
        const std::uint64_t b = id_[static_cast<std::size_t>(w)];
        changes_.push_back({{std::min(a, b), std::max(a, b)}, sign});
    }
}

template <int d>
void Neighbour_changes<d>::note(std::span<const Index> came, std::span<const Index> gone) {
    const Edge_changes changes = edge_changes<d>(came, gone);
    enter(changes.made, 1);
    enter(changes.broken, -1);
}

template <int d>
std::vector<Neighbour_change> Neighbour_changes<d>::take() {
    std::sort(changes_.begin(), changes_.end(), [](const Signed& l, const Signed& r) { return l.pair < r.pair; });
    std::vector<Neighbour_change> out;
    for (std::size_t i = 0; i < changes_.size();) {
        int sum = 0;
        const auto pair = changes_[i].pair;
        for (; i < changes_.size() && changes_[i].pair == pair; ++i) sum += changes_[i].sign;
        if (sum != 0) out.push_back({pair.first, pair.second, sum > 0});
    }
    changes_.clear();
    return out;
}

template class Neighbour_changes<2>;
template class Neighbour_changes<3>;

}  // namespace annulus::inline v1
