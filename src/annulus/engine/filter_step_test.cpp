// SPDX-License-Identifier: GPL-3.0-or-later
// The step test: which vertices left their tolerances, and whether all are where coordinates may be.
#include <annulus/engine/filter.h>

#include <annulus/arithmetic/domain.h>
#include <annulus/mesh/parallel_runs.h>

#include <algorithm>
#include <experimental/simd>

namespace annulus {

/// The one pass over all vertices, of which this is a run. False, with `failed` unspecified, when a coordinate is outside the domain (or
/// is none at all), be it at a vacant index.
template <int d>
bool Filter<d>::find_failed(std::span<const Coordinates<d>> x, std::size_t first, std::size_t last, std::vector<Index>& failed) const {
    using Vector = std::experimental::fixed_size_simd<double, d>;
    constexpr std::experimental::element_aligned_tag elements;
    const Vertex_record<d>* const record = vertex_.data();
    Vector farthest(0.0);  // by coordinate; may miss what is no number, which fails below
    bool near = true;
    if (tracks_) {
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
            near &= within(x[v], coordinate_limit);
            if (x[v] == r.fixed || table_.corner_of(static_cast<Index>(v)) == no_corner) continue;
            failed.push_back(static_cast<Index>(v));
        }
    } else {
        for (std::size_t v = first; v < last; ++v) {
            near &= within(x[v], coordinate_limit);
            if (x[v] != position_[v] && table_.corner_of(static_cast<Index>(v)) != no_corner)
                failed.push_back(static_cast<Index>(v));
        }
    }
    return near && all_of(farthest <= coordinate_limit);
}

template <int d>
bool Filter<d>::find_failed(std::span<const Coordinates<d>> x) {
    constexpr std::size_t run = 1U << 15;
    failed_.clear();
    if (threads_ == 1 || x.size() <= run) return find_failed(x, 0, x.size(), failed_);
    std::vector<std::vector<Index>> failed((x.size() + run - 1) / run);
    std::vector<char> near(failed.size());
    for_each_run(x.size(), run, threads_, [&](std::size_t first, std::size_t last) {
        near[first / run] = find_failed(x, first, last, failed[first / run]) ? 1 : 0;
    });
    for (const auto& here : failed) failed_.insert(failed_.end(), here.begin(), here.end());
    return std::find(near.begin(), near.end(), 0) == near.end();
}

/// What stands at a vacant index does not count.
template <int d>
void Filter<d>::require_domain(std::span<const Coordinates<d>> x) const {
    for (std::size_t v = 0; v < x.size(); ++v)
        if (lives(v)) require_in_domain(x[v]);
}

template class Filter<2>;
template class Filter<3>;

}  // namespace annulus
