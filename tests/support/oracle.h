// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The true half width of a certificate, by two methods that share nothing with the library or with each other: exact
// rational comparisons, and MPFI enclosures of the geometric construction (feet of altitudes, centre of the annulus
// where two bisectors meet).

#include <support/generators.h>

#include <gmpxx.h>
#include <mpfi.h>

namespace annulus::testing {

/// A real number between two MPFR numbers, for a few lines of geometry.
class Enclosure {
  public:
    Enclosure(double x, long precision);
    Enclosure(const Enclosure& o);
    Enclosure& operator=(const Enclosure& o);
    ~Enclosure();

    [[nodiscard]] Enclosure operator+(const Enclosure& o) const;
    [[nodiscard]] Enclosure operator-(const Enclosure& o) const;
    [[nodiscard]] Enclosure operator*(const Enclosure& o) const;
    [[nodiscard]] Enclosure operator/(const Enclosure& o) const;
    [[nodiscard]] Enclosure square() const;
    [[nodiscard]] Enclosure root() const;
    [[nodiscard]] Enclosure least(const Enclosure& o) const;
    [[nodiscard]] Enclosure half() const;

    /// The largest double not above the lower end.
    [[nodiscard]] double lower() const;
    /// The least double not below the upper end.
    [[nodiscard]] double upper() const;
    /// The double next to the middle.
    [[nodiscard]] double middle() const;
    /// The width is below 2^-bits of the value.
    [[nodiscard]] bool is_tight(int bits) const;
    /// True when every number of the enclosure is below y.
    [[nodiscard]] bool is_below(double y) const;
    /// 1 - y / value: positive when y is below the value; the double next to it.
    [[nodiscard]] double slack(double y) const;

  private:
    mpfi_t value_;
};

/// Half the least altitude of a triangle.
class Triangle_truth {
  public:
    explicit Triangle_truth(const Triangle& t);

    /// Exact sign of the orientation.
    [[nodiscard]] int sign() const { return sgn(determinant_); }
    /// y <= half width, exactly: 4 y^2 L <= determinant^2 with L the longest side squared. y >= 0, sign() > 0.
    [[nodiscard]] bool is_at_least(double y) const;
    /// By the feet of the three altitudes.
    [[nodiscard]] Enclosure enclosure() const;

  private:
    Triangle triangle_;
    mpq_class determinant_;
    mpq_class longest_;
};

/// Half the width of the standard annulus of a bi-cell.
class Bicell_truth {
  public:
    explicit Bicell_truth(const Bicell& c);

    /// Exact sign of the empty circle.
    [[nodiscard]] int sign() const { return sgn(determinant_); }
    /// y <= half width, exactly, by the tie test: half width = P / (|M| + |N|), and with r = P^2 - y^2 (|M|^2 + |N|^2)
    /// this is r >= 0 and 4 y^4 |M|^2 |N|^2 <= r^2. y >= 0, sign() > 0.
    [[nodiscard]] bool is_at_least(double y) const;
    /// The same from the rational centre and squared radii r^2 < R^2: 2 y + r <= R.
    [[nodiscard]] bool is_at_least_by_centre(double y) const;
    /// By the centre, in MPFI.
    [[nodiscard]] Enclosure enclosure() const;

    /// Unit vectors from the centre to a, b, p, q.
    [[nodiscard]] std::array<Point, 4> outward() const;

  private:
    Bicell cell_;
    mpq_class determinant_;
    mpq_class inner_, outer_;  // |N|^2, |M|^2
    mpq_class inner_radius_2_, outer_radius_2_;
};

}  // namespace annulus::testing
