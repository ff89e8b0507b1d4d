// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_cut.h>

#include <annulus/error.h>

#include <algorithm>
#include <numeric>
#include <string>

namespace annulus::inline v1 {

namespace {

std::size_t at(Index i) { return static_cast<std::size_t>(i); }

/// The label of sides in the border of the clip.
constexpr Index border = -1;

template <int d>
void require_clip(const Voronoi_clip<d>& clip) {
    for (std::size_t k = 0; k < d; ++k) {
        if (!std::isfinite(clip.lower[k]) || !std::isfinite(clip.upper[k]))
            throw Error(Error_code::not_finite, "the clip has a corner that is not finite");
        if (!(clip.lower[k] < clip.upper[k]))
            throw Error(Error_code::bad_input, "the box of the clip has no interior: lower[" + std::to_string(k) +
                                                   "] is not below upper[" + std::to_string(k) + "]");
    }
    for (std::size_t h = 0; h < clip.half_spaces.size(); ++h) {
        const auto& [normal, offset] = clip.half_spaces[h];
        bool finite = std::isfinite(offset);
        for (const double c : normal) finite = finite && std::isfinite(c);
        if (!finite)
            throw Error(Error_code::not_finite, "half-space " + std::to_string(h) + " of the clip is not finite");
        if (normal == Coordinates<d>{})
            throw Error(Error_code::bad_input, "half-space " + std::to_string(h) + " of the clip has no normal");
    }
}

template <int d>
double absolute_dot(const Coordinates<d>& a, const Coordinates<d>& b) {
    double sum = 0;
    for (std::size_t k = 0; k < d; ++k) sum += std::fabs(a[k] * b[k]);
    return sum;
}
template <int d>
double dot(const Coordinates<d>& a, const Coordinates<d>& b) {
    double sum = a[0] * b[0];
    for (std::size_t k = 1; k < d; ++k) sum += a[k] * b[k];
    return sum;
}

}  // namespace

template <int d>
Voronoi_cut<d>::Voronoi_cut(std::span<const Coordinates<d>> points, std::span<const std::array<Index, 2>> pairs,
                            const Voronoi_clip<d>& clip)
    : x_(points), clip_(clip), begin_(points.size() + 1, 0), index_(2 * pairs.size()) {
    require_clip(clip);
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
        if (!(x[k] - margin > clip_.lower[k] && x[k] + margin < clip_.upper[k])) return false;
    }
    for (const auto& [normal, offset] : clip_.half_spaces) {
        double length = 0;
        for (const double c : normal) length += std::fabs(c);
        const double margin = 2 * length * error + 0x1p-48 * (absolute_dot<d>(normal, x) + std::fabs(offset));
        if (!(dot<d>(normal, x) + margin < offset)) return false;
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
Cut_cell<d> Voronoi_cut<d>::cell(Index v) const {
    const Coordinates<d>& x = x_[at(v)];
    const Coordinates<d> lower = difference(clip_.lower, x);
    const Coordinates<d> upper = difference(clip_.upper, x);
    Coordinates<d> below;
    Coordinates<d> above;
    for (std::size_t k = 0; k < d; ++k) {
        below[k] = lower[k] - 0.5 * (upper[k] - lower[k]);
        above[k] = upper[k] + 0.5 * (upper[k] - lower[k]);
    }
    Convex_cell<d> cell(below, above, border);
    const auto others = neighbours(v);
    for (std::size_t k = 0; k < others.size() && !cell.is_empty(); ++k) {
        const Coordinates<d> e = difference(x_[at(others[k])], x);
        cell.cut(e, 0.5 * dot<d>(e, e), static_cast<Index>(k));
    }
    for (std::size_t k = 0; k < d; ++k) {
        Coordinates<d> axis{};
        axis[k] = 1;
        cell.cut(axis, upper[k], border);
        axis[k] = -1;
        cell.cut(axis, -lower[k], border);
    }
    for (const auto& [normal, offset] : clip_.half_spaces) {
        // offset - normal . x, of which most digits may cancel; long double has some more.
        long double left = offset;
        for (std::size_t k = 0; k < d; ++k) left -= static_cast<long double>(normal[k]) * x[k];
        cell.cut(normal, static_cast<double>(std::ldexp(left, -exponent_)), border);
    }
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
