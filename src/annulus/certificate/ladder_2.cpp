// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/certificate/ladder_2.h>

#include <annulus/arithmetic/rounding_guard.h>

namespace annulus {

namespace {

/// A power of two can itself leave the range of doubles (differences of 2^-1074 want 2^1073): two factors do not.
struct Scale {
    double first;
    double second;
};

Scale split_scale(double m) {
    const int k = m > 0.0 ? -std::ilogb(m) - 1 : 0;
    const int half = k / 2;
    return {std::scalbn(1.0, half), std::scalbn(1.0, k - half)};
}

Vector_2<Interval> scaled(const Coordinates<2>& a, const Coordinates<2>& b, const Scale& s) {
    const Interval second(s.second);
    return {scaled_difference(a[0], b[0], s.first) * second, scaled_difference(a[1], b[1], s.first) * second};
}

template <std::size_t k>
double largest_difference(const std::array<const Coordinates<2>*, k>& x) {
    double m = 0.0;
    for (std::size_t i = 0; i < k; ++i)
        for (std::size_t j = 0; j < i; ++j) m = std::max(m, detail::magnitude(detail::difference(*x[i], *x[j])));
    return m;
}

bool accept(const Width_terms<Interval>& t, const Scale& s, Verdict& out) {
    out.stage = Stage::interval;
    out.tolerance = 0.0;
    if (t.determinant.upper() < 0.0) {
        out.sign = -1;
        return true;
    }
    if (!(t.determinant.lower() > 0.0)) return false;
    out.sign = 1;
    const Interval half_width = t.determinant / (sqrt(t.inner) + sqrt(t.outer));
    const double slack = half_width.upper() - half_width.lower();  // rounded up
    if (!(slack <= bounds::filter_slack * half_width.lower())) return false;
    // Undo the scale: exact unless the result is subnormal; then the lower end of the product is still below.
    const Interval back = half_width / Interval(s.first) / Interval(s.second);
    out.tolerance = std::max(0.0, back.lower());
    return true;
}

template <std::size_t k>
Scaled_integers integers(const std::array<const Coordinates<2>*, k>& x) {
    std::array<double, 2 * k> flat{};
    for (std::size_t i = 0; i < k; ++i) {
        flat[2 * i] = (*x[i])[0];
        flat[2 * i + 1] = (*x[i])[1];
    }
    return Scaled_integers(flat);
}

Vector_2<mpz_class> difference(const Scaled_integers& z, std::size_t i, std::size_t j) {
    return {mpz_class(z.integer[2 * i] - z.integer[2 * j]), mpz_class(z.integer[2 * i + 1] - z.integer[2 * j + 1])};
}

Verdict verdict(const Width_terms<mpz_class>& t, long exponent) {
    Verdict out;
    out.stage = Stage::exact;
    out.sign = static_cast<std::int8_t>(sgn(t.determinant));
    if (out.sign > 0) out.tolerance = quotient_by_roots_lower(t.determinant, t.inner, t.outer, exponent);
    return out;
}

/// Sign of the orientation of three points, nothing else.
int orientation_sign(const Coordinates<2>& a, const Coordinates<2>& b, const Coordinates<2>& c) {
    return orientation_verdict({&a, &b, &c}, false).sign;
}

}  // namespace

bool orientation_interval(const Tuple<2, 3>& x, Verdict& out) {
    const Scale s = split_scale(largest_difference(x));
    return accept(orientation_terms(scaled(*x[1], *x[0], s), scaled(*x[2], *x[0], s), scaled(*x[2], *x[1], s)), s,
                  out);
}

bool empty_sphere_interval(const Tuple<2, 4>& x, Verdict& out) {
    const Scale s = split_scale(largest_difference(x));
    return accept(annulus_terms(scaled(*x[1], *x[0], s), scaled(*x[2], *x[0], s), scaled(*x[3], *x[0], s),
                                scaled(*x[3], *x[2], s)),
                  s, out);
}

Verdict orientation_exact(const Tuple<2, 3>& x) {
    const Scaled_integers z = integers(x);
    return verdict(orientation_terms(difference(z, 1, 0), difference(z, 2, 0), difference(z, 2, 1)), z.exponent);
}

Verdict empty_sphere_exact(const Tuple<2, 4>& x) {
    const Scaled_integers z = integers(x);
    return verdict(
        annulus_terms(difference(z, 1, 0), difference(z, 2, 0), difference(z, 3, 0), difference(z, 3, 2)), z.exponent);
}

Verdict orientation_verdict(const Tuple<2, 3>& x, bool certified) {
    Verdict out;
    if (orientation_filter(x, certified, out)) return out;
    {
        const Rounding_guard guard(FE_UPWARD);
        if (orientation_interval(x, out)) return out;
    }
    return orientation_exact(x);
}

Verdict empty_sphere_verdict(const Tuple<2, 4>& x, bool certified) {
    Verdict out;
    if (empty_sphere_filter(x, certified, out)) return out;
    {
        const Rounding_guard guard(FE_UPWARD);
        if (empty_sphere_interval(x, out)) return out;
    }
    return empty_sphere_exact(x);
}

int perturbed_empty_circle_sign(const Tuple<2, 4>& x) {
    // The triangle a b q is positive; p is the point tested against its circle.
    const Coordinates<2>& t0 = *x[0];
    const Coordinates<2>& t1 = *x[1];
    const Coordinates<2>& t2 = *x[3];
    const Coordinates<2>& p = *x[2];
    std::array<const Coordinates<2>*, 4> order{&t0, &t1, &t2, &p};
    std::sort(order.begin(), order.end(),
              [](const Coordinates<2>* l, const Coordinates<2>* r) { return *l < *r; });
    for (std::size_t i = 3; i > 0; --i) {
        int inside = 0;
        if (order[i] == &p) return 1;
        if (order[i] == &t2 && (inside = orientation_sign(t0, t1, p)) != 0) return -inside;
        if (order[i] == &t1 && (inside = orientation_sign(t0, p, t2)) != 0) return -inside;
        if (order[i] == &t0 && (inside = orientation_sign(p, t1, t2)) != 0) return -inside;
    }
    return 1;
}

}  // namespace annulus
