// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/decide.h>
#include <annulus/predicate/filtered_3.h>
#include <annulus/predicate/sphere_terms.h>

#include <algorithm>
#include <limits>

namespace annulus::inline v1 {

/// The sphere through the corners of a cell, prepared for tests of points: Circumcircle_2 in 3D.
///
/// With u, v, t and w the other corners and the point relative to the first corner, the certificate's determinant is
///   |w|^2 det(u, v, t) - w . n,   n = |u|^2 v x t + |v|^2 t x u + |t|^2 u x v,
/// positive when the point is outside and the cell positive (sphere_terms.h).
/// Errors: bounds.h, proofs/gappa/circumsphere_3.g. The rounding mode must be to nearest.
class Circumsphere_3 {
  public:
    Circumsphere_3(const Coordinates<3>& a, const Coordinates<3>& b, const Coordinates<3>& c, const Coordinates<3>& d)
        : origin_(a) {
        const Vector_3<double> u = detail::difference(b, a);
        const Vector_3<double> v = detail::difference(c, a);
        const Vector_3<double> t = detail::difference(d, a);
        const auto terms = sphere_terms(u, v, t);
        determinant_ = terms.determinant;
        normal_ = terms.normal;
        magnitude_ = std::max(detail::magnitude(u), std::max(detail::magnitude(v), detail::magnitude(t)));
    }

    /// True when the cell is certainly positive. False: it is not, or the next stage has to decide.
    [[nodiscard]] bool positive() const {
        const double error = bounds::orientation_3 * bounds::u * (magnitude_ * magnitude_ * magnitude_);
        return determinant_ > error && magnitude_ <= bounds::filter_range_3 &&
               magnitude_ * bounds::filter_range_3 >= 1.0;
    }
    /// True when p is certainly outside. Precondition: positive(). False: it is not, or the next stage has to decide.
    [[nodiscard]] bool excludes(const Coordinates<3>& p) const { return beside<1>(p); }
    /// True only when the cell is positive and all points are outside, each certainly: as in Circumcircle_2.
    template <class... P>
    [[nodiscard]] bool excludes_all(const P&... p) const {
        double m = magnitude_;
        double least = std::numeric_limits<double>::infinity();
        ((least = std::min(least, outside_of(p, m))), ...);
        return (int{clear(least, m)} & int{positive()}) != 0;
    }
    /// True when p is certainly inside. Precondition: positive(). False: it is not, or the next stage has to decide.
    [[nodiscard]] bool contains(const Coordinates<3>& p) const { return beside<-1>(p); }

  private:
    /// The determinant; m is raised to the largest coordinate.
    [[nodiscard]] double outside_of(const Coordinates<3>& p, double& m) const {
        const Vector_3<double> w = detail::difference(p, origin_);
        m = std::max(m, detail::magnitude(w));
        return sphere_determinant(normal_, determinant_, w);
    }
    /// Whether a determinant of coordinates up to m is above its error.
    [[nodiscard]] static bool clear(double determinant, double m) {
        const double m2 = m * m;
        return (int{determinant > bounds::circumsphere_3 * bounds::u * (m2 * m2 * m)} &
                int{m <= bounds::filter_range_3}) != 0;
    }
    template <int side>
    [[nodiscard]] bool beside(const Coordinates<3>& p) const {
        double m = magnitude_;
        const double determinant = outside_of(p, m);
        return clear(side * determinant, m);
    }

    Coordinates<3> origin_;
    Vector_3<double> normal_;
    double determinant_;
    double magnitude_;  // largest coordinate of u, v and t
};

}  // namespace annulus::inline v1
