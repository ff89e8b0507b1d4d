// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/predicate/half_width.h>

#include <annulus/arithmetic/exact.h>
#include <annulus/predicate/interval_stage.h>
#include <annulus/predicate/later_stages.h>
#include <annulus/predicate/width_terms.h>
#include <annulus/predicate/width_terms_3.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <type_traits>

namespace annulus::inline v1 {

namespace {

// ---- What half a width is made of, over any number type. `from(i, j)` is the vector from point j to point i. ------

template <class T, class From>
Width_terms<T> terms(const Tuple<2, 3>&, Width which, const From& from) {
    const Width_terms<T> t = orientation_terms<T>(from(1, 0), from(2, 0), from(2, 1));
    if (which == Width::least) return t;
    const Vector_2<T> u = from(1, 0);
    const T side = squared(u.x) + squared(u.y);
    return {t.determinant, side, side};
}

template <class T>
T magnitude_of(const T& x) {
    using std::abs;
    return T(abs(x));
}

template <class T, class From>
Width_terms<T> terms(const Tuple<3, 4>&, Width which, const From& from) {
    if (which == Width::least) return orientation_terms<T>(from(1, 0), from(2, 0), from(3, 0));
    const bool ridge = which == Width::ridge;
    const Vector_3<T> n = cross<T>(from(1, 0), ridge ? from(3, 2) : from(2, 0));
    const T height = dot<T>(n, ridge ? from(2, 0) : from(3, 0));
    const T norm = square<T>(n);
    return {ridge ? magnitude_of(height) : height, norm, norm};
}

/// The annuli of a bi-cell. They share the determinant, and the first is the paper's.
template <class T, std::size_t n>
struct Annuli_terms {
    T determinant;
    std::array<T, n> inner;
    std::array<T, n> outer;
};

template <class T, class From>
Annuli_terms<T, 1> annuli(const Tuple<2, 4>&, const From& from) {
    const Width_terms<T> t = annulus_terms<T>(from(1, 0), from(2, 0), from(3, 0), from(3, 2));
    return {t.determinant, {t.inner}, {t.outer}};
}

template <class T, class From>
Annuli_terms<T, partitions_3> annuli(const Tuple<3, 5>&, const From& from) {
    static_assert(abc_pq == 0);
    const Bicell_terms_3<T> t = annulus_terms<T>(from(1, 0), from(2, 0), from(3, 0), from(4, 0));
    return {t.determinant, t.inner, t.outer};
}

// ---- Intervals. The rounding mode is upward. ----------------------------------------------------------------------

/// sqrt(x) + sqrt(y), a lower bound: a root rounded upward is at most 1 + 2^-52 times the root.
double roots_lower(const Interval& x, const Interval& y) {
    constexpr double less = 1.0 - 0x1p-51;
    const double r = -(-std::sqrt(std::max(x.lower(), 0.0)) * less);
    const double s = -(-std::sqrt(std::max(y.lower(), 0.0)) * less);
    return -(-r - s);
}

/// Bounds of a sum of two norms.
struct Norms {
    double least;
    double most;
};
Norms norms(const Interval& inner, const Interval& outer) {
    return {roots_lower(inner, outer), detail::roots_upper(inner, outer)};
}

/// Divides a determinant by norms. Returns false where it is not certainly positive or the ends are too far apart.
bool quotient(const Interval& determinant, const Norms& n, const detail::Scale& s, Half_width& out) {
    if (!(n.least > 0.0)) return false;
    const double lower = detail::quotient_lower(determinant.lower(), n.most);
    const double upper = determinant.upper() / n.least;
    if (!detail::within_slack(lower, upper)) return false;
    out.lower = detail::unscaled_lower(lower, s);
    out.upper = upper / s.first / s.second;
    out.stage = Stage::interval;
    // A subnormal result has lost precision.
    return out.lower >= std::numeric_limits<double>::min() && std::isfinite(out.upper);
}

bool enclosed(const Width_terms<Interval>& t, const detail::Scale& s, Half_width& out) {
    out = {};
    if (!(t.determinant.lower() > 0.0)) return t.determinant.upper() < 0.0;
    return quotient(t.determinant, norms(t.inner, t.outer), s, out);
}

template <std::size_t n>
bool enclosed(const Annuli_terms<Interval, n>& t, const detail::Scale& s, Bicell_half_widths& out) {
    out = {};
    if (!(t.determinant.lower() > 0.0)) return t.determinant.upper() < 0.0;
    const Norms standard = norms(t.inner[0], t.outer[0]);
    Norms greatest{0.0, 0.0};  // of the others
    for (std::size_t k = 1; k < n; ++k) {
        const Norms other = norms(t.inner[k], t.outer[k]);
        greatest = {std::max(greatest.least, other.least), std::max(greatest.most, other.most)};
    }
    out.standard_is_least = standard.least >= greatest.most;
    if (!out.standard_is_least && greatest.least <= standard.most) return false;
    if (!quotient(t.determinant, standard, s, out.standard)) return false;
    out.least = out.standard;
    return out.standard_is_least || quotient(t.determinant, greatest, s, out.least);
}

template <std::size_t d, std::size_t k, class Evaluate>
bool with_interval_vectors(const std::array<const std::array<double, d>*, k>& x, Evaluate evaluate) {
    return detail::with_scale(x, [&](const auto& difference, const detail::Scale& s) {
        return evaluate([&](std::size_t i, std::size_t j) { return detail::difference(x, i, j, difference); }, s);
    });
}

template <class X>
[[gnu::noinline]] bool by_intervals(const X& x, Width which, Half_width& out) {
    return with_interval_vectors(
        x, [&](const auto& from, const detail::Scale& s) { return enclosed(terms<Interval>(x, which, from), s, out); });
}
template <class X>
[[gnu::noinline]] bool by_intervals(const X& x, Bicell_half_widths& out) {
    return with_interval_vectors(
        x, [&](const auto& from, const detail::Scale& s) { return enclosed(annuli<Interval>(x, from), s, out); });
}

// ---- Integers -----------------------------------------------------------------------------------------------------

Half_width exact_quotient(const mpz_class& determinant, const mpz_class& inner, const mpz_class& outer, long exponent) {
    Half_width out{0.0, 0.0, Stage::exact};
    if (sgn(determinant) <= 0) return out;
    out.lower = quotient_by_roots_lower(determinant, inner, outer, exponent);
    out.upper = std::nextafter(out.lower, std::numeric_limits<double>::infinity());
    return out;
}

template <std::size_t d, std::size_t k, class Evaluate>
auto with_integer_vectors(const std::array<const std::array<double, d>*, k>& x, Evaluate evaluate) {
    const Scaled_integers z(coordinates(x));
    constexpr int dimension = static_cast<int>(d);
    return evaluate([&](std::size_t i, std::size_t j) { return detail::difference<dimension>(z, i, j); }, z.exponent);
}

template <class X>
Half_width by_integers(const X& x, Width which) {
    return with_integer_vectors(x, [&](const auto& from, long exponent) {
        const Width_terms<mpz_class> t = terms<mpz_class>(x, which, from);
        return exact_quotient(t.determinant, t.inner, t.outer, exponent);
    });
}

template <class X>
Bicell_half_widths bicell_by_integers(const X& x) {
    return with_integer_vectors(x, [&](const auto& from, long exponent) {
        const auto t = annuli<mpz_class>(x, from);
        Bicell_half_widths out;
        out.standard = exact_quotient(t.determinant, t.inner[0], t.outer[0], exponent);
        out.least = out.standard;
        for (std::size_t k = 1; k < t.inner.size(); ++k) {
            const Half_width other = exact_quotient(t.determinant, t.inner[k], t.outer[k], exponent);
            if (other.lower < out.least.lower) out.least = other;
        }
        out.standard_is_least = out.least.lower == out.standard.lower;
        return out;
    });
}

// ---- Batches ------------------------------------------------------------------------------------------------------

Stage& stage_of(Half_width& h) { return h.stage; }
Stage& stage_of(Bicell_half_widths& h) { return h.least.stage; }

template <class X, class Out, class... Which>
void enclose_all(std::span<const X> x, std::span<Out> out, Which... which) {
    assert(x.size() == out.size());
    for (Out& o : out) stage_of(o) = Stage::exact;  // until intervals answer
    (void)later_stages(
        x.size(), [&](std::size_t i) { return stage_of(out[i]) == Stage::exact; },
        [&](std::size_t i) {
            const bool decided = by_intervals(x[i], which..., out[i]);
            stage_of(out[i]) = decided ? Stage::interval : Stage::exact;
            return decided;
        },
        [&](std::size_t i) { out[i] = enclose_exactly(x[i], which...); });
}

}  // namespace

void enclose(std::span<const Tuple<2, 3>> x, Width which, std::span<Half_width> out) { enclose_all(x, out, which); }
void enclose(std::span<const Tuple<3, 4>> x, Width which, std::span<Half_width> out) { enclose_all(x, out, which); }
void enclose(std::span<const Tuple<2, 4>> x, std::span<Bicell_half_widths> out) { enclose_all(x, out); }
void enclose(std::span<const Tuple<3, 5>> x, std::span<Bicell_half_widths> out) { enclose_all(x, out); }

Half_width enclose_exactly(const Tuple<2, 3>& x, Width which) { return by_integers(x, which); }
Half_width enclose_exactly(const Tuple<3, 4>& x, Width which) { return by_integers(x, which); }
Bicell_half_widths enclose_exactly(const Tuple<2, 4>& x) { return bicell_by_integers(x); }
Bicell_half_widths enclose_exactly(const Tuple<3, 5>& x) { return bicell_by_integers(x); }

}  // namespace annulus::inline v1
