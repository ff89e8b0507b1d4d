// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/kept_border_2.h>

#include <annulus/error.h>
#include <apps/motion/vector_2.h>

#include <algorithm>

namespace annulus::inline v1 {

Kept_border_2::Kept_border_2(const Region_2& domain, std::span<const Coordinates<2>> position) {
    if (domain.hull().kind() != Domain_2::Kind::polygon)
        throw Error(Error_code::usage, "vertices are kept on the border of polygons only, not of a disc");
    const double slack = 1e5 * domain.tolerance();
    const auto corners = domain.hull().corners();
    if (domain.convex())
        for (std::size_t i = 0; i < corners.size(); ++i)
            edges_.push_back({corners[i], corners[i + 1 < corners.size() ? i + 1 : 0]});
    else edges_.assign(domain.triangles().edges().begin(), domain.triangles().edges().end());
    const auto nearest = [&](const Coordinates<2>& p) {
        if (!domain.convex()) return domain.triangles().edge_at(p, slack);
        const auto near = [&](const auto& edge) { return norm(minus(nearest_on(edge, p), p)) <= slack; };
        return static_cast<std::size_t>(std::find_if(edges_.begin(), edges_.end(), near) - edges_.begin());
    };
    for (const Coordinates<2>& p : position) {
        const std::size_t edge = nearest(p);
        edge_.push_back(edge < edges_.size() ? edge : elsewhere);
        if (edge == edges_.size()) continue;
        ++count_;
        for (const Coordinates<2>& end : edges_[edge])
            if (norm(minus(end, p)) <= slack) edge_.back() = corner;
    }
}

Coordinates<2> Kept_border_2::along(std::size_t v, const Coordinates<2>& from, const Coordinates<2>& p) const {
    if (edge_[v] == corner) return from;
    const auto& [a, b] = edges_[edge_[v]];
    const Coordinates<2> d = minus(b, a);
    const double square = dot(d, d);
    const double at = std::clamp(dot(minus(from, a), d) / square, 0.0, 1.0);
    const double t = std::clamp(dot(minus(p, a), d) / square, at / 2, (1 + at) / 2);
    return {a[0] + t * d[0], a[1] + t * d[1]};
}

}  // namespace annulus::inline v1
