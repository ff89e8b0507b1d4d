// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/moments_image.h>

#include <apps/motion/gauss_legendre.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// Positions are seen from the node to the lower left of the origin, so that they keep all their bits.
class Walk {
  public:
    Walk(const Image_density& image, const Coordinates<2>& origin)
        : image_(image),
          column_(below(origin[0], image.width())),
          row_(below(origin[1], image.height())),
          c_{origin[0] + 0.5 - static_cast<double>(column_), origin[1] + 0.5 - static_cast<double>(row_)} {}

    void edge(const Coordinates<2>& from, const Coordinates<2>& to) {
        Coordinates<2> a{c_[0] + from[0], c_[1] + from[1]}, b{c_[0] + to[0], c_[1] + to[1]};
        double sign = 1;
        if (a[1] > b[1]) std::swap(a, b), sign = -1;
        // Row by row upwards; a level edge contributes nothing.
        const double slope = (b[0] - a[0]) / (b[1] - a[1]);
        for (Coordinates<2> p = a; p[1] < b[1];) {
            const double top = std::floor(p[1]) + 1;
            const Coordinates<2> q = top < b[1] ? Coordinates<2>{a[0] + (top - a[1]) * slope, top} : b;
            in_row(p, q, sign);
            p = q;
        }
    }

    [[nodiscard]] Moments_2 moments() const {
        return mass_ > 1e-10 * size_ ? Moments_2{mass_, {first_[0], first_[1]}} : Moments_2{};
    }

  private:
    static std::int64_t below(double x, std::size_t size) {
        return static_cast<std::int64_t>(std::clamp(std::floor(x + 0.5), 0.0, static_cast<double>(size)));
    }

    /// The part of an edge within a row of nodes, column by column to the right.
    void in_row(Coordinates<2> a, Coordinates<2> b, double sign) {
        const double bottom = std::floor(a[1]);
        const auto row = static_cast<std::size_t>(std::clamp(row_ + static_cast<std::int64_t>(bottom), std::int64_t{0},
                                                             static_cast<std::int64_t>(image_.height())));
        if (a[0] > b[0]) std::swap(a, b);
        const double slope = (b[1] - a[1]) / (b[0] - a[0]);
        for (Coordinates<2> p = a;;) {
            const double right = std::floor(p[0]) + 1;
            const bool last = !(right < b[0]);
            const Coordinates<2> q = last ? b : Coordinates<2>{right, a[1] + (right - a[0]) * slope};
            piece(p, q, row, bottom, sign * std::abs(q[1] - p[1]));
            if (last) return;
            p = q;
        }
    }

    /// P and Q (from the node of the origin) along a row, as polynomials in s, the distance from a node.
    struct Row_polynomials {
        double p0, p1, p2, q0, q1, q2, q3;
        Row_polynomials(const Image_density& image, std::int64_t at, std::int64_t from, std::size_t row) {
            const auto &here = image.node(static_cast<std::size_t>(at), row),
                       &next = image.node(static_cast<std::size_t>(at) + 1, row),
                       &start = image.node(static_cast<std::size_t>(from), row);
            const std::int64_t sum = here.sum - start.sum, moment = here.moment - start.moment - 3 * from * sum;
            const auto weight = static_cast<double>(here.weight), rise = static_cast<double>(next.weight - here.weight),
                       x = static_cast<double>(at - from);
            p0 = static_cast<double>(sum) / 2, p1 = weight, p2 = rise / 2;
            q0 = static_cast<double>(moment) / 6, q1 = x * weight, q2 = (x * rise + weight) / 2, q3 = rise / 3;
        }
        [[nodiscard]] double p(double s) const { return p0 + s * (p1 + s * p2); }
        [[nodiscard]] double q(double s) const { return q0 + s * (q1 + s * (q2 + s * q3)); }
    };

    void piece(const Coordinates<2>& a, const Coordinates<2>& b, std::size_t row, double bottom, double rise) {
        const std::int64_t at = std::clamp(column_ + static_cast<std::int64_t>(std::floor((a[0] + b[0]) / 2)),
                                           std::int64_t{0}, static_cast<std::int64_t>(image_.width()));
        const Row_polynomials low(image_, at, column_, row), high(image_, at, column_, row + 1);
        const auto left = static_cast<double>(at - column_);
        const Gauss_rule& rule = gauss_rule(3);
        for (std::size_t k = 0; k < 3; ++k) {
            const double x = a[0] + rule.node[k] * (b[0] - a[0]), y = a[1] + rule.node[k] * (b[1] - a[1]);
            const double s = x - left, t = y - bottom, w = rule.weight[k] * rise;
            const double p = low.p(s) + t * (high.p(s) - low.p(s)), q = low.q(s) + t * (high.q(s) - low.q(s));
            mass_ += w * p;
            size_ += std::abs(w * p);
            first_[0] += w * (q - c_[0] * p);
            first_[1] += w * p * (y - c_[1]);
        }
    }

    const Image_density& image_;
    std::int64_t column_, row_;
    Coordinates<2> c_;
    double mass_ = 0, size_ = 0, first_[2] = {0, 0};
};

}  // namespace

Moments_2 image_moments(const Image_density& density, const Coordinates<2>& origin, std::span<const Corner_2> corners) {
    if (corners.empty()) return {};
    Walk walk(density, origin);
    const Corner_2* a = &corners.back();
    for (const Corner_2& b : corners) {
        walk.edge(a->offset, b.offset);
        a = &b;
    }
    return walk.moments();
}

Moments_2 placed_moments(const Placed_image& density, const Coordinates<2>& origin, std::span<const Corner_2> corners) {
    const Coordinates<2>& pixel = density.pixel;
    boost::container::small_vector<Corner_2, 32> scaled;
    for (const Corner_2& corner : corners)
        scaled.push_back({{corner.offset[0] / pixel[0], corner.offset[1] / pixel[1]}, false});
    Moments_2 m = image_moments(density.image, density.in_image(origin), {scaled.data(), scaled.size()});
    const double area = pixel[0] * pixel[1];
    m.mass *= area;
    for (std::size_t k = 0; k < 2; ++k) m.first[k] *= area * pixel[k];
    return m;
}

}  // namespace annulus::inline v1
