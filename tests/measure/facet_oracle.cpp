// SPDX-License-Identifier: GPL-3.0-or-later
#include <measure/facet_oracle.h>

#include <algorithm>

namespace annulus::testing {

namespace {

using Number = mpq_class;
template <std::size_t k>
using Numbers = std::array<Number, k>;

/// The positions x with normal . x <= offset.
template <std::size_t k>
struct Plane {
    Numbers<k> normal;
    Number offset;
};

/// Beyond every corner of a bounded cell (voronoi_oracle.cpp).
const Number& beyond_all() {
    static const Number x = Number(mpz_class(1) << 6500);
    return x;
}

template <std::size_t k>
Number dot(const Numbers<k>& a, const Numbers<k>& b) {
    Number sum = 0;
    for (std::size_t i = 0; i < k; ++i) sum += a[i] * b[i];
    return sum;
}

/// A convex set on a line or in a plane; its measure, and its moments.
template <std::size_t k>
class Section;

template <>
class Section<1> {
  public:
    void cut(const Plane<1>& h) {
        const Number& n = h.normal[0];
        if (sgn(n) == 0) {
            if (sgn(h.offset) < 0) high_ = low_;
            return;
        }
        const Number t = h.offset / n;
        if (sgn(n) > 0) high_ = std::min(high_, t);
        else low_ = std::max(low_, t);
        if (high_ < low_) high_ = low_;
    }
    [[nodiscard]] Number measure() const { return high_ - low_; }
    [[nodiscard]] Numbers<1> centroid() const { return {Number((low_ + high_) / 2)}; }
    [[nodiscard]] bool is_unbounded() const {
        return sgn(measure()) > 0 && (low_ == -beyond_all() || high_ == beyond_all());
    }

  private:
    Number low_ = -beyond_all(), high_ = beyond_all();
};

template <>
class Section<2> {
  public:
    Section() {
        const Number& l = beyond_all();
        corners_ = {{-l, -l}, {l, -l}, {l, l}, {-l, l}};
    }
    void cut(const Plane<2>& h) {
        std::vector<Numbers<2>> kept;
        std::vector<Number> beyond;
        for (const auto& p : corners_) beyond.push_back(dot<2>(h.normal, p) - h.offset);
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const std::size_t n = (i + 1) % corners_.size();
            if (sgn(beyond[i]) <= 0) kept.push_back(corners_[i]);
            if (sgn(beyond[i]) * sgn(beyond[n]) >= 0) continue;
            const Number t = beyond[i] / (beyond[i] - beyond[n]);
            kept.push_back({Number(corners_[i][0] + t * (corners_[n][0] - corners_[i][0])),
                            Number(corners_[i][1] + t * (corners_[n][1] - corners_[i][1]))});
        }
        corners_ = std::move(kept);
    }
    [[nodiscard]] Number measure() const {
        Number twice = 0;
        for (std::size_t i = 0; i < corners_.size(); ++i) twice += turn(i);
        return twice / 2;
    }
    [[nodiscard]] Numbers<2> centroid() const {
        Numbers<2> sum;
        for (std::size_t i = 0; i < corners_.size(); ++i)
            for (std::size_t k = 0; k < 2; ++k)
                sum[k] += turn(i) * (corners_[i][k] + corners_[(i + 1) % corners_.size()][k]);
        for (Number& c : sum) c /= 6 * measure();
        return sum;
    }
    [[nodiscard]] bool is_unbounded() const {
        return std::any_of(corners_.begin(), corners_.end(),
                           [](const auto& p) { return abs(p[0]) == beyond_all() || abs(p[1]) == beyond_all(); }) &&
               sgn(measure()) > 0;
    }

  private:
    [[nodiscard]] Number turn(std::size_t i) const {
        const auto& p = corners_[i];
        const auto& q = corners_[(i + 1) % corners_.size()];
        return p[0] * q[1] - p[1] * q[0];
    }
    std::vector<Numbers<2>> corners_;
};

/// The planes of the cell, with points[v] at the origin.
template <int d>
std::vector<Plane<static_cast<std::size_t>(d)>> planes_of(std::span<const Coordinates<d>> points, std::size_t v,
                                                          const Voronoi_clip<d>* clip) {
    constexpr auto k = static_cast<std::size_t>(d);
    Numbers<k> home;
    for (std::size_t i = 0; i < k; ++i) home[i] = points[v][i];
    std::vector<Plane<k>> out;
    for (std::size_t p = 0; p < points.size(); ++p) {
        if (p == v) continue;
        auto& plane = out.emplace_back();
        for (std::size_t i = 0; i < k; ++i) plane.normal[i] = points[p][i] - home[i];
        plane.offset = dot<k>(plane.normal, plane.normal) / 2;
    }
    if (clip == nullptr) return out;
    for (std::size_t i = 0; i < k; ++i) {
        auto& above = out.emplace_back();
        above.normal[i] = 1;
        above.offset = clip->upper[i] - home[i];
        auto& below = out.emplace_back();
        below.normal[i] = -1;
        below.offset = home[i] - clip->lower[i];
    }
    for (const auto& [normal, offset] : clip->half_spaces) {
        auto& plane = out.emplace_back();
        for (std::size_t i = 0; i < k; ++i) plane.normal[i] = normal[i];
        plane.offset = offset - dot<k>(plane.normal, home);
    }
    return out;
}

}  // namespace

template <int d>
Exact_polytope<d> exact_polytope(std::span<const Coordinates<d>> points, std::size_t v, const Voronoi_clip<d>* clip) {
    constexpr auto n = static_cast<std::size_t>(d);
    const auto planes = planes_of<d>(points, v, clip);
    Exact_polytope<d> out;
    Numbers<n> moment;
    for (const auto& plane : planes) {
        std::size_t k = 0;
        while (sgn(plane.normal[k]) == 0) ++k;
        // In the plane, over the other coordinates.
        Section<n - 1> section;
        for (const auto& other : planes) {
            if (&other == &plane) continue;
            const Number ratio = other.normal[k] / plane.normal[k];
            Plane<n - 1> cut{{}, other.offset - ratio * plane.offset};
            for (std::size_t i = 1; i < n; ++i) {
                const std::size_t a = (k + i) % n;
                cut.normal[i - 1] = other.normal[a] - ratio * plane.normal[a];
            }
            section.cut(cut);
        }
        Exact_side<d> side;
        const Number measure = section.measure();  // over the projection, whose factor is |normal| / |normal_k|
        side.bounded = !section.is_unbounded();
        side.square = measure * measure * dot<n>(plane.normal, plane.normal) / (plane.normal[k] * plane.normal[k]);
        if (side.bounded && sgn(measure) > 0) {
            const auto inside = section.centroid();
            Number rest = plane.offset;
            for (std::size_t i = 1; i < n; ++i) {
                const std::size_t a = (k + i) % n;
                side.centroid[a] = inside[i - 1];
                rest -= plane.normal[a] * inside[i - 1];
            }
            side.centroid[k] = rest / plane.normal[k];
            const Number pyramid = plane.offset * measure / (d * abs(plane.normal[k]));
            out.volume += pyramid;
            for (std::size_t i = 0; i < n; ++i) {
                moment[i] += pyramid * side.centroid[i] * d / (d + 1);
                side.centroid[i] += points[v][i];
            }
        }
        out.sides.push_back(std::move(side));
    }
    if (sgn(out.volume) > 0)
        for (std::size_t i = 0; i < n; ++i) out.centroid[i] = points[v][i] + moment[i] / out.volume;
    return out;
}

template Exact_polytope<2> exact_polytope<2>(std::span<const Coordinates<2>>, std::size_t, const Voronoi_clip<2>*);
template Exact_polytope<3> exact_polytope<3>(std::span<const Coordinates<3>>, std::size_t, const Voronoi_clip<3>*);

}  // namespace annulus::testing
