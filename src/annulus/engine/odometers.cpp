// SPDX-License-Identifier: GPL-3.0-or-later
// Odometers: started, tested at every step, dropped.
#include <annulus/engine/odometers.h>

#include <annulus/arithmetic/domain.h>

#include <cmath>
#include <experimental/simd>

namespace annulus {

template <int d>
void Odometers<d>::drop() noexcept {
    kept_ = false;
    release(vertex_);
    release(list_);
    expiries_.free();
    looks_.free();
}

template <int d>
void Odometers<d>::resize() {
    const std::size_t n = at(table_.vertex_bound());
    grow(vertex_, n);
    grow(list_, n);
    expiries_.resize(table_.cell_bound());
    looks_.resize(table_.facet_bound());
}

template <int d>
void Odometers<d>::begin(std::span<const Coordinates<d>> x) {
    kept_ = false;
    resize();
    for (std::size_t v = 0; v < x.size(); ++v) vertex_[v] = {x[v], {}};
    std::fill(list_.begin(), list_.end(), List{});
}

template <int d>
void Odometers<d>::finish_beginning() {
    for (Index v = 0; v < table_.vertex_bound(); ++v)
        if (table_.corner_of(v) != no_corner) set_threshold(v);
    kept_ = true;
}

template <int d>
void Odometers<d>::place(Index v, const Coordinates<d>& p) {
    vertex_[at(v)] = {p, {}};
    list_[at(v)].clear();
}

/// The one pass over all vertices, of which this is a run.
template <int d>
bool Odometers<d>::find_failed(std::span<const Coordinates<d>> x, std::size_t first, std::size_t last,
                               std::vector<Index>& failed) const {
    using Vector = std::experimental::fixed_size_simd<double, d>;
    constexpr std::experimental::element_aligned_tag elements;
    const Vertex_record<d>* const record = vertex_.data();
    Vector farthest(0.0);  // by coordinate; may miss what is no number, which fails below
    bool near = true;
    for (std::size_t v = first; v < last; ++v) {
        const Vertex_record<d>& r = record[v];
        const Vector p(x[v].data(), elements);
        farthest = max(farthest, abs(p));
        const Vector fixed(r.fixed.data(), elements);
        const Vector off = (p - fixed) * (p - fixed);
        double squares = off[0];
        for (std::size_t k = 1; k < static_cast<std::size_t>(d); ++k) squares += off[k];
        if (squares < r.threshold.value()) [[likely]]
            continue;
        near &= in_domain(x[v]);
        if (x[v] == r.fixed || table_.corner_of(static_cast<Index>(v)) == no_corner) continue;
        failed.push_back(static_cast<Index>(v));
    }
    return near && all_of(farthest <= coordinate_limit);
}

template class Odometers<2>;
template class Odometers<3>;

}  // namespace annulus
