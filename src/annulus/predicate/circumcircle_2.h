// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/decide.h>
#include <annulus/predicate/sphere_terms.h>

#include <algorithm>
#include <limits>

namespace annulus::inline v1 {

/// The circle through the corners of a triangle, prepared for tests of points: signs of certificates only, where no
/// tolerance is needed. The triangle's contribution is computed once for its three edges, so all signs of a
/// triangulation cost a third of its tolerances.
///
/// With u, v, w the second corner, the third and the point relative to the first, the certificate's determinant is
///   | u |u|^2 |   = w . n + |w|^2 (u x v),   n = (u.y |v|^2 - v.y |u|^2, v.x |u|^2 - u.x |v|^2),
///   | v |v|^2 |
///   | w |w|^2 |   positive when the point is outside and the triangle positive (sphere_terms.h).
/// Errors: bounds.h, proofs/gappa/circumcircle_2.g. The rounding mode must be to nearest.
class Circumcircle_2 {
  public:
    Circumcircle_2(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c) : origin_(a) {
        const Vector_2<double> u = detail::difference(b, a);
        const Vector_2<double> v = detail::difference(c, a);
        const auto terms = sphere_terms(u, v);
        twice_area_ = terms.determinant;
        normal_ = terms.normal;
        magnitude_ = std::max(detail::magnitude(u), detail::magnitude(v));
    }

    /// True when the triangle is certainly positive. False: it is not, or the next stage has to decide.
    [[nodiscard]] bool positive() const {
        const double error = bounds::orientation_2 * bounds::u * (magnitude_ * magnitude_);
        return twice_area_ > error && magnitude_ <= bounds::filter_range && magnitude_ * bounds::filter_range >= 1.0;
    }
    /// True when p is certainly outside. Precondition: positive(). False: it is not, or the next stage has to decide.
    [[nodiscard]] bool excludes(const Coordinates<2>& p) const { return beside<1>(p); }
    /// True only when the triangle is positive and all points are outside, each certainly: compares the least
    /// determinant with the error bound of the largest coordinate, without a branch. This implies positive() and
    /// excludes() of each point, since a bound grows with its coordinate (and where a determinant may overflow that
    /// coordinate is beyond the range). Precondition: the coordinates are numbers.
    template <class... P>
    [[nodiscard]] bool excludes_all(const P&... p) const {
        double m = magnitude_;
        double least = std::numeric_limits<double>::infinity();
        ((least = std::min(least, outside_of(p, m))), ...);
        return (int{clear(least, m)} & int{positive()}) != 0;
    }
    /// True when p is certainly inside. Precondition: positive(). False: it is not, or the next stage has to decide.
    [[nodiscard]] bool contains(const Coordinates<2>& p) const { return beside<-1>(p); }

  private:
    /// The determinant; m is raised to the largest coordinate.
    [[nodiscard]] double outside_of(const Coordinates<2>& p, double& m) const {
        const Vector_2<double> w = detail::difference(p, origin_);
        m = std::max(m, detail::magnitude(w));
        return sphere_determinant(normal_, twice_area_, w);
    }
    /// Whether a determinant of coordinates up to m is above its error.
    [[nodiscard]] static bool clear(double determinant, double m) {
        const double m2 = m * m;
        return (int{determinant > bounds::circumcircle_2 * bounds::u * (m2 * m2)} & int{m <= bounds::filter_range}) !=
               0;
    }
    template <int side>
    [[nodiscard]] bool beside(const Coordinates<2>& p) const {
        double m = magnitude_;
        const double determinant = outside_of(p, m);
        return clear(side * determinant, m);
    }

    Coordinates<2> origin_;
    Vector_2<double> normal_;
    double twice_area_;
    double magnitude_;  // largest coordinate of u and v
};

}  // namespace annulus::inline v1
