// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/certificate/ladder_2.h>

#include <annulus/certificate/interval_stage.h>

namespace annulus {

namespace {

/// Terms of a half width as an answer of the interval stage.
bool accept(const Width_terms<Interval>& t, const detail::Scale& s, Verdict& out) {
    if (!detail::interval_sign(t.determinant, out)) return false;
    if (out.sign < 0) return true;
    double lower = 0.0;
    if (!detail::quotient_lower_tight(t.determinant, detail::roots_upper(t.inner, t.outer),
                                      detail::roots_about(t.inner, t.outer), lower))
        return false;
    out.tolerance = detail::unscaled_lower(lower, s);
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
    return detail::with_scale(x, [&](const auto& difference, const detail::Scale& s) {
        const auto vector = [&](std::size_t i, std::size_t j) {
            return Vector_2<Interval>{difference((*x[i])[0], (*x[j])[0]), difference((*x[i])[1], (*x[j])[1])};
        };
        return accept(orientation_terms(vector(1, 0), vector(2, 0), vector(2, 1)), s, out);
    });
}

bool empty_sphere_interval(const Tuple<2, 4>& x, Verdict& out) {
    return detail::with_scale(x, [&](const auto& difference, const detail::Scale& s) {
        const auto vector = [&](std::size_t i, std::size_t j) {
            return Vector_2<Interval>{difference((*x[i])[0], (*x[j])[0]), difference((*x[i])[1], (*x[j])[1])};
        };
        return accept(annulus_terms(vector(1, 0), vector(2, 0), vector(3, 0), vector(3, 2)), s, out);
    });
}

Verdict orientation_exact(const Tuple<2, 3>& x) {
    const Scaled_integers z = integers(x);
    return verdict(orientation_terms(difference(z, 1, 0), difference(z, 2, 0), difference(z, 2, 1)), z.exponent);
}

Verdict empty_sphere_exact(const Tuple<2, 4>& x) {
    const Scaled_integers z = integers(x);
    return verdict(annulus_terms(difference(z, 1, 0), difference(z, 2, 0), difference(z, 3, 0), difference(z, 3, 2)),
                   z.exponent);
}

int perturbed_empty_circle_sign(const Tuple<2, 4>& x) {
    // The triangle a b q is positive; p is the point tested against its circle.
    const Coordinates<2>& t0 = *x[0];
    const Coordinates<2>& t1 = *x[1];
    const Coordinates<2>& t2 = *x[3];
    const Coordinates<2>& p = *x[2];
    std::array<const Coordinates<2>*, 4> order{&t0, &t1, &t2, &p};
    std::sort(order.begin(), order.end(), [](const Coordinates<2>* l, const Coordinates<2>* r) { return *l < *r; });
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
