// SPDX-License-Identifier: GPL-3.0-or-later
#include <measure/voronoi_oracle.h>

#include <algorithm>
#include <array>
#include <vector>

namespace annulus::testing {

namespace {

using Number = mpq_class;
using Corner = std::array<Number, 2>;

/// The points with a x + b y <= c.
struct Half_plane {
    Number a, b, c;
};

/// A bound beyond every corner of a bounded cell of points in the coordinate domain: coordinates are multiples of
/// 2^-1074 below 2^501, and corners quotients of polynomials of degree 4 and 3 in them.
const Number& far_away() {
    static const Number x = Number(mpz_class(1) << 6500);
    return x;
}

class Polygon {
  public:
    Polygon() {
        const Number& l = far_away();
        corners_ = {{-l, -l}, {l, -l}, {l, l}, {-l, l}};
    }
    void cut(const Half_plane& h) {
        std::vector<Corner> kept;
        std::vector<Number> beyond;
        for (const Corner& p : corners_) beyond.push_back(h.a * p[0] + h.b * p[1] - h.c);
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const std::size_t k = (i + 1) % corners_.size();
            if (sgn(beyond[i]) <= 0) kept.push_back(corners_[i]);
            if (sgn(beyond[i]) * sgn(beyond[k]) >= 0) continue;
            const Number t = beyond[i] / (beyond[i] - beyond[k]);
            kept.push_back({Number(corners_[i][0] + t * (corners_[k][0] - corners_[i][0])),
                            Number(corners_[i][1] + t * (corners_[k][1] - corners_[i][1]))});
        }
        corners_ = std::move(kept);
    }
    [[nodiscard]] Number area() const {
        Number twice = 0;
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const Corner& p = corners_[i];
            const Corner& q = corners_[(i + 1) % corners_.size()];
            twice += p[0] * q[1] - p[1] * q[0];
        }
        return twice / 2;
    }
    /// Whether a corner of the square is still there and the area is positive.
    [[nodiscard]] bool unbounded() const {
        return std::any_of(corners_.begin(), corners_.end(),
                           [](const Corner& p) { return abs(p[0]) == far_away() || abs(p[1]) == far_away(); }) &&
               sgn(area()) != 0;
    }

  private:
    std::vector<Corner> corners_;
};

template <int d>
std::vector<std::array<Number, static_cast<std::size_t>(d)>> others_seen_from(std::span<const Coordinates<d>> points,
                                                                              std::size_t v) {
    std::vector<std::array<Number, static_cast<std::size_t>(d)>> out;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (i == v) continue;
        auto& n = out.emplace_back();
        for (std::size_t k = 0; k < d; ++k) n[k] = Number(points[i][k]) - Number(points[v][k]);
    }
    return out;
}

}  // namespace

std::optional<mpq_class> exact_cell(std::span<const Coordinates<2>> points, std::size_t v) {
    Polygon cell;
    for (const auto& n : others_seen_from<2>(points, v)) cell.cut({n[0], n[1], (n[0] * n[0] + n[1] * n[1]) / 2});
    if (cell.unbounded()) return std::nullopt;
    return cell.area();
}

std::optional<mpq_class> exact_cell(std::span<const Coordinates<3>> points, std::size_t v) {
    const auto others = others_seen_from<3>(points, v);
    Number volume = 0;
    for (const auto& n : others) {
        const Number square = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        std::size_t k = 0;
        while (sgn(n[k]) == 0) ++k;
        const std::size_t i = (k + 1) % 3;
        const std::size_t j = (k + 2) % 3;
        // In the bisector, over the coordinates i and j.
        Polygon facet;
        for (const auto& m : others) {
            if (&m == &n) continue;
            const Number ratio = m[k] / n[k];
            facet.cut({m[i] - ratio * n[i], m[j] - ratio * n[j],
                       (m[0] * m[0] + m[1] * m[1] + m[2] * m[2] - ratio * square) / 2});
        }
        if (facet.unbounded()) return std::nullopt;
        volume +=
            square * facet.area() / (6 * abs(n[k]));  // height |n| / 2, area over the projection |n| / |n_k|, a third
    }
    // All on a line: bisectors that are not cut are unbounded. Also for a single point.
    if (others.empty()) return std::nullopt;
    return volume;
}

}  // namespace annulus::testing
