// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/voronoi.h>

#include <annulus/error.h>
#include <annulus/measure/clip_planes.h>
#include <annulus/measure/convex_cell.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

namespace annulus::inline v1 {

namespace {

constexpr double farthest = 0x1p1000;

/// The box around a region: what is cut, a little larger than it, and the next one, much smaller.
template <int d>
class Region_box {
  public:
    explicit Region_box(std::span<const Half_space<d>> half_spaces) : planes_(clip_planes<d>(half_spaces)) {
        // A corner of planes that are nearly parallel may be far beyond them: 2^20 times as far as any of them is where
        // the region counts as unbounded.
        long double largest = 0;
        for (const Clip_plane<d>& p : planes_) {
            long double length = 0;
            for (const double c : p.normal) length = std::hypot(length, static_cast<long double>(c));
            largest = std::max(largest, std::fabs(p.offset) / length);
        }
        half_.fill(largest > 0 ? static_cast<double>(std::min<long double>(0x1p20L * largest, farthest)) : 1);
        cut(true);
        const double edge = std::ldexp(half_[0], -exponent_);
        for (std::size_t k = 0; k < d; ++k)
            if (lower_[k] <= -edge || upper_[k] >= edge)
                throw Error(Error_code::bad_input, "the half-spaces of the clip do not bound it");
    }

    /// The digits of a small region far from the origin are few in the first box; in smaller ones there are more.
    Voronoi_clip<d> operator()() {
        for (int round = 0; round < 60 && shrink(); ++round) cut(true);
        cut(false);
        Voronoi_clip<d> out;
        constexpr double infinity = std::numeric_limits<double>::infinity();
        double far = 0;
        for (const double c : centre_) far = std::max(far, std::ldexp(std::fabs(c), -exponent_));
        for (std::size_t k = 0; k < d; ++k) {
            const double margin = 0x1p-40 * (upper_[k] - lower_[k]) + 0x1p-56 * far;
            out.lower[k] = std::nextafter(centre_[k] + std::ldexp(lower_[k] - margin, exponent_), -infinity);
            out.upper[k] = std::nextafter(centre_[k] + std::ldexp(upper_[k] + margin, exponent_), infinity);
        }
        return out;
    }

  private:
    /// Cuts the box in a unit in which it is about 1, and finds the bounds of what is left. A generous cut leaves more,
    /// by more than all roundings.
    void cut(bool generously) {
        exponent_ = std::ilogb(*std::max_element(half_.begin(), half_.end())) + 1;
        Coordinates<d> lower;
        Coordinates<d> upper;
        for (std::size_t k = 0; k < d; ++k) {
            upper[k] = std::ldexp(half_[k], -exponent_);
            lower[k] = -upper[k];
        }
        Convex_cell<d> cell(lower, upper, -1);
        for (const Clip_plane<d>& p : planes_) {
            long double offset = std::ldexp(p.inside(centre_), -exponent_);
            if (generously) offset += std::ldexp(p.terms(centre_), -exponent_ - 60) + 0x1p-46L;
            cell.cut(p.normal, static_cast<double>(offset), 0);
        }
        if (cell.is_empty() || !(cell.content().volume > 0))
            throw Error(Error_code::bad_input, "the half-spaces of the clip have no position in common");
        std::tie(lower_, upper_) = cell.bounds();
    }

    /// The bounds are the next box; whether that is less than half as large.
    bool shrink() {
        double before = 0;
        double after = 0;
        for (std::size_t k = 0; k < d; ++k) {
            before = std::max(before, half_[k]);
            centre_[k] += std::ldexp(lower_[k] + 0.5 * (upper_[k] - lower_[k]), exponent_);
            half_[k] =
                std::ldexp(0.5 * (upper_[k] - lower_[k]), exponent_) + 0x1p-51 * std::fabs(centre_[k]) + 0x1p-1074;
            after = std::max(after, half_[k]);
        }
        return after < 0.5 * before;
    }

    std::vector<Clip_plane<d>> planes_;
    Coordinates<d> centre_{}, half_{};  // of the box, in the caller's unit
    int exponent_ = 0;
    Coordinates<d> lower_{}, upper_{};  // of what is left of it, from the centre, in the unit 2^exponent
};

}  // namespace

template <int d>
Voronoi_clip<d> voronoi_clip(std::span<const Half_space<d>> half_spaces) {
    Voronoi_clip<d> out = Region_box<d>(half_spaces)();
    out.half_spaces.assign(half_spaces.begin(), half_spaces.end());
    return out;
}

template Voronoi_clip<2> voronoi_clip<2>(std::span<const Half_space<2>>);
template Voronoi_clip<3> voronoi_clip<3>(std::span<const Half_space<3>>);

}  // namespace annulus::inline v1
