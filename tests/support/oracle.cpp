// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.h"

#include <mpfr.h>

#include <algorithm>

namespace annulus::testing {

// ---- Enclosure --------------------------------------------------------------------------------------------------

namespace {

/// An MPFR number for intermediate results.
struct Number {
    mpfr_t value;
    Number() { mpfr_init2(value, 600); }
    ~Number() { mpfr_clear(value); }
    Number(const Number&) = delete;
    Number& operator=(const Number&) = delete;
};

}  // namespace

Enclosure::Enclosure(double x, long precision) {
    mpfi_init2(value_, precision);
    mpfi_set_d(value_, x);
}
Enclosure::Enclosure(const Enclosure& o) {
    mpfi_init2(value_, mpfi_get_prec(o.value_));
    mpfi_set(value_, o.value_);
}
Enclosure& Enclosure::operator=(const Enclosure& o) {
    if (this != &o) {
        mpfi_set_prec(value_, mpfi_get_prec(o.value_));
        mpfi_set(value_, o.value_);
    }
    return *this;
}
Enclosure::~Enclosure() { mpfi_clear(value_); }

Enclosure Enclosure::operator+(const Enclosure& o) const {
    Enclosure r(*this);
    mpfi_add(r.value_, value_, o.value_);
    return r;
}
Enclosure Enclosure::operator-(const Enclosure& o) const {
    Enclosure r(*this);
    mpfi_sub(r.value_, value_, o.value_);
    return r;
}
Enclosure Enclosure::operator*(const Enclosure& o) const {
    Enclosure r(*this);
    mpfi_mul(r.value_, value_, o.value_);
    return r;
}
Enclosure Enclosure::operator/(const Enclosure& o) const {
    Enclosure r(*this);
    mpfi_div(r.value_, value_, o.value_);
    return r;
}
Enclosure Enclosure::square() const {
    Enclosure r(*this);
    mpfi_sqr(r.value_, value_);
    return r;
}
Enclosure Enclosure::root() const {
    Enclosure r(*this);
    mpfi_sqrt(r.value_, value_);
    return r;
}
Enclosure Enclosure::half() const {
    Enclosure r(*this);
    mpfi_div_2ui(r.value_, value_, 1);
    return r;
}
Enclosure Enclosure::least(const Enclosure& o) const {
    Enclosure r(*this);
    mpfr_min(&r.value_->left, &value_->left, &o.value_->left, MPFR_RNDD);
    mpfr_min(&r.value_->right, &value_->right, &o.value_->right, MPFR_RNDU);
    return r;
}

double Enclosure::lower() const { return mpfr_get_d(&value_->left, MPFR_RNDD); }
double Enclosure::upper() const { return mpfr_get_d(&value_->right, MPFR_RNDU); }
double Enclosure::middle() const {
    Number m;
    mpfi_mid(m.value, value_);
    return mpfr_get_d(m.value, MPFR_RNDN);
}

bool Enclosure::is_tight(int bits) const {
    if (!(mpfr_sgn(&value_->left) > 0)) return false;
    Number width;
    mpfr_sub(width.value, &value_->right, &value_->left, MPFR_RNDU);
    mpfr_mul_2si(width.value, width.value, bits, MPFR_RNDU);
    return mpfr_cmp(width.value, &value_->left) <= 0;
}

bool Enclosure::is_below(double y) const { return mpfr_cmp_d(&value_->right, y) < 0; }

double Enclosure::slack(double y) const {
    Number difference, ratio;
    mpfr_sub_d(difference.value, &value_->left, y, MPFR_RNDN);
    mpfr_div(ratio.value, difference.value, &value_->left, MPFR_RNDN);
    return mpfr_get_d(ratio.value, MPFR_RNDN);
}

// ---- Vectors ----------------------------------------------------------------------------------------------------

namespace {

struct Rational_vector {
    mpq_class x, y;
};

Rational_vector from(const Point& origin, const Point& p) {
    return {mpq_class(p[0]) - mpq_class(origin[0]), mpq_class(p[1]) - mpq_class(origin[1])};
}
Rational_vector minus(const Rational_vector& l, const Rational_vector& r) { return {l.x - r.x, l.y - r.y}; }
mpq_class dot(const Rational_vector& l, const Rational_vector& r) { return l.x * r.x + l.y * r.y; }
mpq_class cross(const Rational_vector& l, const Rational_vector& r) { return l.x * r.y - l.y * r.x; }
mpq_class norm(const Rational_vector& v) { return dot(v, v); }

struct Enclosed_vector {
    Enclosure x, y;
};

Enclosed_vector from(const Point& origin, const Point& p, long precision) {
    return {Enclosure(p[0], precision) - Enclosure(origin[0], precision),
            Enclosure(p[1], precision) - Enclosure(origin[1], precision)};
}
Enclosed_vector minus(const Enclosed_vector& l, const Enclosed_vector& r) { return {l.x - r.x, l.y - r.y}; }
Enclosure dot(const Enclosed_vector& l, const Enclosed_vector& r) { return l.x * r.x + l.y * r.y; }
Enclosure length(const Enclosed_vector& v) { return (v.x.square() + v.y.square()).root(); }

/// 500 bits, which is enough but for the wildest cases.
constexpr long usual_precision = 500;
constexpr long great_precision = 9000;
constexpr int tight = 110;

}  // namespace

// ---- Triangle ---------------------------------------------------------------------------------------------------

Triangle_truth::Triangle_truth(const Triangle& t) : triangle_(t) {
    const Rational_vector u = from(t.a, t.b), v = from(t.a, t.c), w = from(t.b, t.c);
    determinant_ = cross(u, v);
    longest_ = std::max({norm(u), norm(v), norm(w)});
}

bool Triangle_truth::is_at_least(double y) const {
    const mpq_class left = 4 * mpq_class(y) * mpq_class(y) * longest_;
    const mpq_class right = determinant_ * determinant_;
    return left <= right;
}

namespace {

/// The distance of c from the line through a and b, by the foot of c on it.
Enclosure altitude(const Point& a, const Point& b, const Point& c, long precision) {
    const Enclosed_vector along = from(a, b, precision);
    const Enclosed_vector to = from(a, c, precision);
    const Enclosure t = dot(to, along) / dot(along, along);
    return length(minus(to, {t * along.x, t * along.y}));
}

}  // namespace

Enclosure Triangle_truth::enclosure() const {
    const auto at = [&t = triangle_](long precision) {
        const Enclosure from_c = altitude(t.a, t.b, t.c, precision);
        const Enclosure from_a = altitude(t.b, t.c, t.a, precision);
        const Enclosure from_b = altitude(t.c, t.a, t.b, precision);
        return from_a.least(from_b).least(from_c).half();
    };
    const Enclosure e = at(usual_precision);
    return e.is_tight(tight) ? e : at(great_precision);
}

// ---- Bi-cell ----------------------------------------------------------------------------------------------------

Bicell_truth::Bicell_truth(const Bicell& c) : cell_(c) {
    // The determinant of the lifted points, seen from p; positive inside, so its negative is the certificate's.
    const Rational_vector i = from(c.p, c.a), j = from(c.p, c.b), k = from(c.p, c.q);
    determinant_ = norm(i) * cross(k, j) + norm(j) * cross(i, k) + norm(k) * cross(j, i);

    const Rational_vector b = from(c.a, c.b), p = from(c.a, c.p), q = from(c.a, c.q);
    const mpq_class D = cross(b, q) - cross(b, p);
    const mpq_class s = dot(minus(q, p), minus({q.x + p.x, q.y + p.y}, b));
    const Rational_vector N{D * b.x - s * b.y, D * b.y + s * b.x};
    inner_ = norm(N);
    outer_ = norm(minus(N, {2 * D * p.x, 2 * D * p.y}));

    // The centre x lies on both bisectors: b.x = |b|^2 / 2 and (q - p).x = (|q|^2 - |p|^2) / 2.
    if (D == 0) return;
    const Rational_vector e = minus(q, p);
    const mpq_class f = norm(b) / 2, g = (norm(q) - norm(p)) / 2;
    const mpq_class det = cross(b, e);
    const Rational_vector centre{(f * e.y - g * b.y) / det, (g * b.x - f * e.x) / det};
    inner_radius_2_ = norm(centre);
    outer_radius_2_ = norm(minus(p, centre));
}

bool Bicell_truth::is_at_least(double y) const {
    const mpq_class y2 = mpq_class(y) * mpq_class(y);
    const mpq_class r = determinant_ * determinant_ - y2 * (inner_ + outer_);
    if (sgn(r) < 0) return false;
    const mpq_class left = 4 * y2 * y2 * inner_ * outer_;
    const mpq_class right = r * r;
    return left <= right;
}

bool Bicell_truth::is_at_least_by_centre(double y) const {
    // 2 y + sqrt(r2) <= sqrt(R2)  <=>  4 y sqrt(r2) <= R2 - r2 - 4 y^2
    const mpq_class exact_y(y);
    const mpq_class rest = outer_radius_2_ - inner_radius_2_ - 4 * exact_y * exact_y;
    if (sgn(rest) < 0) return false;
    const mpq_class left = 16 * exact_y * exact_y * inner_radius_2_;
    const mpq_class right = rest * rest;
    return left <= right;
}

namespace {

/// The centre of the standard annulus relative to a.
Enclosed_vector centre(const Bicell& c, long precision) {
    const Enclosed_vector b = from(c.a, c.b, precision), p = from(c.a, c.p, precision), q = from(c.a, c.q, precision);
    const Enclosed_vector e = minus(q, p);
    // The midpoint of a b plus t times its normal, where it meets the bisector of p q.
    const Enclosed_vector middle_ab{b.x.half(), b.y.half()};
    const Enclosed_vector middle_pq{(p.x + q.x).half(), (p.y + q.y).half()};
    const Enclosed_vector normal{Enclosure(0, precision) - b.y, b.x};
    const Enclosure t = dot(e, minus(middle_pq, middle_ab)) / dot(e, normal);
    return {middle_ab.x + t * normal.x, middle_ab.y + t * normal.y};
}

}  // namespace

Enclosure Bicell_truth::enclosure() const {
    const auto at = [&c = cell_](long precision) {
        const Enclosed_vector o = centre(c, precision);
        const Enclosure inner = length(minus(from(c.a, c.b, precision), o));
        const Enclosure outer = length(minus(from(c.a, c.q, precision), o));
        return (outer - inner).half();
    };
    const Enclosure e = at(usual_precision);
    return e.is_tight(tight) ? e : at(great_precision);
}

std::array<Point, 4> Bicell_truth::outward() const {
    std::array<Point, 4> directions;
    const auto points = cell_.tuple();
    for (std::size_t i = 0; i < 4; ++i)
        for (const long precision : {usual_precision, great_precision}) {
            const Enclosed_vector v = minus(from(cell_.a, *points[i], precision), centre(cell_, precision));
            const Enclosure length_of_v = length(v);
            directions[i] = {(v.x / length_of_v).middle(), (v.y / length_of_v).middle()};
            if (length_of_v.is_tight(tight)) break;
        }
    return directions;
}

}  // namespace annulus::testing
