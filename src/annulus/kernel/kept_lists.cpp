// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/kernel/kept_lists.h>

namespace annulus::inline v1 {

/// Precondition: this thread holds the lock.
template <int d>
const std::shared_ptr<const Cell_lists<d>>& Kept_lists<d>::listed(Positions x) const {
    const State now = state();
    if (cells_ && kept_ == now) return cells_;
    cells_.reset();
    neighbours_.reset();
    hull_.reset();
    cells_ = std::make_shared<const Cell_lists<d>>(mesh_.cells(x), mesh_.dimension(), x.size());
    kept_ = now;
    return cells_;
}

template <int d>
std::shared_ptr<const Cell_lists<d>> Kept_lists<d>::cells(Positions x) const {
    const std::lock_guard hold(listing_);
    return listed(x);
}

template <int d>
std::shared_ptr<const Vertex_neighbours> Kept_lists<d>::neighbours(Positions x) const {
    const std::lock_guard hold(listing_);
    const auto& cells = listed(x);
    if (!neighbours_) neighbours_ = std::make_shared<const Vertex_neighbours>(vertex_neighbours(*cells));
    return neighbours_;
}

template <int d>
auto Kept_lists<d>::hull(Positions x) const -> std::shared_ptr<const Facets> {
    const std::lock_guard hold(listing_);
    const auto& cells = listed(x);
    if (!hull_) hull_ = std::make_shared<const Facets>(hull_facets(*cells));
    return hull_;
}

template class Kept_lists<2>;
template class Kept_lists<3>;

}  // namespace annulus::inline v1
