// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_cut.h>

#include <annulus/error.h>
#include <annulus/measure/saturated.h>
#include <annulus/mesh/at.h>
#include <annulus/space/dot.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace annulus::inline v1 {

namespace {

/// The label of sides in the border of the clip.
constexpr Index border = -1;

template <int d>
void require_box(const Voronoi_clip<d>& clip) {
    for (std::size_t k = 0; k < d; ++k) {
        if (!std::isfinite(clip.lower[k]) || !std::isfinite(clip.upper[k]))
            throw Error(Error_code::not_finite, "the clip has a corner that is not finite");
        if (!(clip.lower[k] < clip.upper[k]))
            throw Error(Error_code::bad_input, "the box of the clip has no interior: lower[" + std::to_string(k) +
                                                   "] is not below upper[" + std::to_string(k) + "]");
    }
}

}  // namespace

template <int d>
Voronoi_cut<d>::Voronoi_cut(std::span<const Coordinates<d>> points, std::span<const std::array<Index, 2>> pairs,
                            const Voronoi_clip<d>& clip)
    : x_(points),
      lower_(clip.lower),
      upper_(clip.upper),
      planes_((require_box(clip), clip_planes<d>(clip.half_spaces))),
      begin_(points.size() + 1, 0),
      index_(2 * pairs.size()) {
    double largest = 0;
    const auto note = [&largest](double x) { largest = std::max(largest, std::fabs(x)); };
    for (const auto& x : {clip.lower, clip.upper})
        for (const double c : x) note(c);
    for (const auto& pair : pairs)
        for (const Index v : pair) {
            ++begin_[at(v) + 1];
            for (const double c : x_[at(v)]) note(c);
        }
    exponent_ = std::clamp(std::ilogb(largest) + 2, -1000, 1000);
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::size_t> end(begin_.begin(), begin_.end() - 1);
    for (const auto& [i, j] : pairs) {
        index_[end[at(i)]++] = j;
        index_[end[at(j)]++] = i;
    }
}

template <int d>
bool Voronoi_cut<d>::is_inside(const Coordinates<d>& x, double error) const {
    for (std::size_t k = 0; k < d; ++k) {
        const double margin = error + 0x1p-50 * std::fabs(x[k]);
        if (!(x[k] - margin > lower_[k] && x[k] + margin < upper_[k])) return false;
    }
    for (const Clip_plane<d>& plane : planes_) {
        double length = 0;
        for (const double c : plane.normal) length += std::fabs(c);
        if (!(plane.inside(x) > 2 * length * error + 0x1p-48L * plane.terms(x))) return false;
    }
    return true;
}

template <int d>
std::span<const Index> Voronoi_cut<d>::neighbours(Index v) const {
    return std::span(index_).subspan(begin_[at(v)], begin_[at(v) + 1] - begin_[at(v)]);
}

/// (a - b) in the unit.
template <int d>
Coordinates<d> Voronoi_cut<d>::difference(const Coordinates<d>& a, const Coordinates<d>& b) const {
    const double scale = std::ldexp(1.0, -exponent_);
    Coordinates<d> out;
    for (std::size_t k = 0; k < d; ++k) out[k] = (a[k] - b[k]) * scale;
    return out;
}

template <int d>
double Voronoi_cut<d>::measure(double in_unit, int power) const {
    return saturated(std::ldexp(static_cast<long double>(in_unit), power * exponent_));
}

template <int d>
Coordinates<d> Voronoi_cut<d>::position(Index v, const Coordinates<d>& from_v) const {
    Coordinates<d> out;
    for (std::size_t k = 0; k < d; ++k) out[k] = x_[at(v)][k] + std::ldexp(from_v[k], exponent_);
    return out;
}

template <int d>
Convex_cell<d> Voronoi_cut<d>::polytope(Index v) const {
    const Coordinates<d>& x = x_[at(v)];
    const Coordinates<d> lower = difference(lower_, x);
    const Coordinates<d> upper = difference(upper_, x);
    Coordinates<d> below;
    Coordinates<d> above;
    for (std::size_t k = 0; k < d; ++k) {
        below[k] = lower[k] - 0.5 * (upper[k] - lower[k]);
        above[k] = upper[k] + 0.5 * (upper[k] - lower[k]);
    }
    Convex_cell<d> cell(below, above, border);
    const auto others = neighbours(v);
    for (std::size_t k = 0; k < others.size() && !cell.is_empty(); ++k) {
        Coordinates<d> e;  // in a unit in which it is about 1: in that of the clip it might underflow
        double most = 0;
        for (std::size_t a = 0; a < d; ++a) {
            e[a] = x_[at(others[k])][a] - x[a];
            most = std::max(most, std::fabs(e[a]));
        }
        const int size = std::ilogb(most);
        for (double& c : e) c = std::ldexp(c, -size);
        cell.cut(e, std::ldexp(0.5 * dot<d>(e, e), size - exponent_), static_cast<Index>(k));
    }
    for (std::size_t k = 0; k < d; ++k) {
        Coordinates<d> axis{};
        axis[k] = 1;
        cell.cut(axis, upper[k], border);
        axis[k] = -1;
        cell.cut(axis, -lower[k], border);
    }
    for (const Clip_plane<d>& plane : planes_)
        cell.cut(plane.normal, static_cast<double>(std::ldexp(plane.inside(x), -exponent_)), border);
    return cell;
}

template <int d>
Cut_cell<d> Voronoi_cut<d>::cell(Index v) const {
    const Convex_cell<d> cell = polytope(v);
    const auto others = neighbours(v);
    Cut_cell<d> out{cell.content(), 0, {}};
    for (std::size_t k = 0; k < others.size(); ++k) out.facets.push_back({static_cast<Index>(k), 0, {}});
    for (const Cell_side<d>& side : cell.sides()) {
        out.surface += side.measure;
        if (side.label == border || !(side.measure > 0)) continue;
        Cell_side<d>& facet = out.facets[at(side.label)];
        const double share = side.measure / (facet.measure + side.measure);
        for (std::size_t k = 0; k < d; ++k) facet.centroid[k] += share * (side.centroid[k] - facet.centroid[k]);
        facet.measure += side.measure;
    }
    return out;
}

template class Voronoi_cut<2>;
template class Voronoi_cut<3>;

}  // namespace annulus::inline v1
