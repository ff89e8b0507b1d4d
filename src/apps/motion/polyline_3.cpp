// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/nearest_search.h>
#include <apps/motion/polyline_3.h>
#include <apps/motion/vectors_3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace annulus::inline v1 {

Polyline_3::Polyline_3(std::vector<Coordinates<3>> points) : points_(std::move(points)), up_to_{0} {
    for (std::size_t i = 1; i < points_.size(); ++i)
        up_to_.push_back(up_to_.back() + distance(points_[i - 1], points_[i]));
    for (std::size_t first = 0; first + 1 < points_.size(); first += run)
        boxes_.push_back(box_of(first, std::min(first + run, points_.size() - 1)));
    box_ = box_of(0, points_.size() - 1);
}

Polyline_3::Box Polyline_3::box_of(std::size_t first, std::size_t last) const {
    Box b{points_[first], points_[first]};
    for (std::size_t i = first; i <= last; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            b.lower[k] = std::min(b.lower[k], points_[i][k]);
            b.upper[k] = std::max(b.upper[k], points_[i][k]);
        }
    return b;
}

Coordinates<3> Polyline_3::at(double way) const {
    if (closed()) way -= length() * std::floor(way / length());
    if (!(way > 0)) return points_.front();
    if (way >= length()) return points_.back();
    const auto after = static_cast<std::size_t>(std::upper_bound(up_to_.begin(), up_to_.end(), way) - up_to_.begin());
    const double from = up_to_[after - 1];
    return between(points_[after - 1], points_[after], (way - from) / (up_to_[after] - from));
}

double Polyline_3::nearest(const Coordinates<3>& p) const {
    double least = std::numeric_limits<double>::infinity(), way = 0;
    const auto look = [&](std::size_t r) {
        for (std::size_t i = r * run; i < std::min((r + 1) * run, points_.size() - 1); ++i) {
            const Coordinates<3> d = minus(points_[i + 1], points_[i]), e = minus(p, points_[i]);
            const double t = std::clamp(dot(d, e) / dot(d, d), 0.0, 1.0);
            const Coordinates<3> off = minus(p, between(points_[i], points_[i + 1], t));
            if (const double square = dot(off, off); square < least) {
                least = square;
                way = up_to_[i] + t * (up_to_[i + 1] - up_to_[i]);
            }
        }
    };
    const auto gap = [&](std::size_t r) { return squared_gap(p, boxes_[r].lower, boxes_[r].upper); };
    std::size_t first = 0;  // of the runs that may be nearest
    for (std::size_t r = 1; r < boxes_.size(); ++r)
        if (gap(r) < gap(first)) first = r;
    look(first);
    for (std::size_t r = 0; r < boxes_.size(); ++r)
        if (r != first && gap(r) < least) look(r);
    return way;
}

}  // namespace annulus::inline v1
