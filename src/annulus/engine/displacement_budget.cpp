// SPDX-License-Identifier: GPL-3.0-or-later
// Displacement_budget: how it starts, the step test, how it is dropped.
#include <annulus/engine/displacement_budget.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/engine/trace.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

template <int d>
void Displacement_budget<d>::drop() noexcept {
    kept_ = false;
    release(vertex_);
    release(list_);
    expiries_.free();
}

template <int d>
void Displacement_budget<d>::resize() {
    const std::size_t n = at(table_.vertex_bound());
    grow(vertex_, n);
    grow(list_, n);
    expiries_.resize(table_.cell_bound());
}

template <int d>
void Displacement_budget<d>::begin(std::span<const Coordinates<d>> x) {
    kept_ = false;
    resize();
    for (std::size_t v = 0; v < x.size(); ++v) vertex_[v] = {x[v], {}};
    std::fill(list_.begin(), list_.end(), List{});
    ANNULUS_TRACED(begun(*this, x));
}

template <int d>
void Displacement_budget<d>::finish_beginning() {
    for (Index v = 0; v < table_.vertex_bound(); ++v)
        if (table_.corner_of(v) != no_corner) set_threshold(v);
    kept_ = true;
    ANNULUS_TRACED(recomputed(*this));
}

template <int d>
void Displacement_budget<d>::add_vertex(Index v, const Coordinates<d>& p) {
    vertex_[at(v)] = {p, {}};
    list_[at(v)].clear();
    ANNULUS_TRACED(placed(*this, v));
}

/// A run of the one pass over all vertices.
template <int d>
bool Displacement_budget<d>::find_failed(std::span<const Coordinates<d>> x, std::size_t first, std::size_t last,
                                         std::vector<Index>& failed) const {
    const Vertex_record<d>* const record = vertex_.data();
    double farthest = 0.0;  // coordinate; may miss a NaN, which fails below
    bool near = true;
    for (std::size_t v = first; v < last; ++v) {
        const Vertex_record<d>& r = record[v];
        const Coordinates<d>& p = x[v];
        double squares = 0.0;
        for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
            const double off = p[k] - r.fixed[k];
            squares += off * off;
            farthest = std::max(farthest, std::fabs(p[k]));
        }
        if (squares < r.threshold.value()) [[likely]]
            continue;
        near &= in_domain(p);
        if (p == r.fixed || table_.corner_of(static_cast<Index>(v)) == no_corner) continue;
        failed.push_back(static_cast<Index>(v));
    }
    return near && farthest <= coordinate_limit;
}

template class Displacement_budget<2>;
template class Displacement_budget<3>;

}  // namespace annulus::inline v1
