// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/neighbour_changes.h>

#include <algorithm>

namespace annulus::inline v1 {

template <int d>
void Neighbour_changes<d>::name(Index v, std::uint64_t id) {
    const auto at = static_cast<std::size_t>(v);
    if (at >= id_.size()) id_.resize(at + 1);
    id_[at] = id;
}

template <int d>
void Neighbour_changes<d>::edges_of(std::span<const Index> cells, Edges& edges) {
    edges.clear();
    for (std::size_t c = 0; c < cells.size(); c += d + 1)
        for (std::size_t i = c; i <= c + d; ++i)
            for (std::size_t k = c; k < i; ++k)
                if (cells[i] >= 0 && cells[k] >= 0)  // neither infinity nor padding
                    edges.emplace_back(std::min(cells[i], cells[k]), std::max(cells[i], cells[k]));
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
}

/// The edges that are not in `others`.
template <int d>
void Neighbour_changes<d>::enter(const Edges& edges, const Edges& others, int sign) {
    auto other = others.begin();
    for (const auto& edge : edges) {
        while (other != others.end() && *other < edge) ++other;
        if (other != others.end() && *other == edge) continue;
        const std::uint64_t a = id_[static_cast<std::size_t>(edge.first)],
                            b = id_[static_cast<std::size_t>(edge.second)];
        changes_.push_back({{std::min(a, b), std::max(a, b)}, sign});
    }
}

template <int d>
void Neighbour_changes<d>::note(std::span<const Index> came, std::span<const Index> gone) {
    edges_of(came, came_);
    edges_of(gone, gone_);
    enter(came_, gone_, 1);
    enter(gone_, came_, -1);
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
