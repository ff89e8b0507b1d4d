// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/predicate/filtered_2.h>

#include <annulus/predicate/integer_signs.h>
#include <annulus/predicate/interval_stage.h>

#include <optional>

namespace annulus::inline v1 {

namespace {

// vector(i, j) is point i minus point j.
template <class Vectors>
auto triangle_terms(const Vectors& vector) {
    return orientation_terms(vector(1, 0), vector(2, 0), vector(2, 1));
}
template <class Vectors>
auto bicell_terms(const Vectors& vector) {
    return annulus_terms(vector(1, 0), vector(2, 0), vector(3, 0), vector(3, 2));
}

/// Stores terms of a half width as the answer of the interval stage.
bool accept(const Width_terms<Interval>& t, const detail::Scale& s, Certificate_value& out) {
    if (!detail::interval_sign(t.determinant, out)) return false;
    if (out.sign < 0) return true;
    double lower = 0.0;
    if (!detail::quotient_lower_in_slack(t.determinant, detail::roots_upper(t.inner, t.outer),
                                         detail::roots_about(t.inner, t.outer), lower))
        return false;
    out.tolerance = detail::unscaled_lower(lower, s);
    return true;
}

/// What does not hold has no tolerance.
std::optional<Certificate_value> without_tolerance(std::optional<int> sign) {
    if (!sign || *sign > 0) return {};
    return Certificate_value{0.0, static_cast<std::int8_t>(*sign), Stage::exact};
}

Certificate_value value_of(const Width_terms<mpz_class>& t, long exponent) {
    Certificate_value out;
    out.stage = Stage::exact;
    out.sign = static_cast<std::int8_t>(sgn(t.determinant));
    if (out.sign > 0) out.tolerance = quotient_by_roots_lower(t.determinant, t.inner, t.outer, exponent);
    return out;
}

}  // namespace

bool orientation_interval(const Tuple<2, 3>& x, Certificate_value& out) {
    return detail::with_scale(x, [&](const auto& minus, const detail::Scale& s) {
        return accept(triangle_terms(detail::vectors(x, minus)), s, out);
    });
}

bool empty_sphere_interval(const Tuple<2, 4>& x, Certificate_value& out) {
    return detail::with_scale(x, [&](const auto& minus, const detail::Scale& s) {
        return accept(bicell_terms(detail::vectors(x, minus)), s, out);
    });
}

Certificate_value orientation_exact(const Tuple<2, 3>& x) {
    if (const auto value = without_tolerance(integer_orientation<2>(scaled_points(x)))) return *value;
    const Scaled_integers z(coordinates(x));
    return value_of(triangle_terms(detail::vectors<2>(z)), z.exponent);
}

Certificate_value empty_sphere_exact(const Tuple<2, 4>& x) {
    if (const auto value = without_tolerance(integer_empty_sphere<2>(scaled_points(x)))) return *value;
    const Scaled_integers z(coordinates(x));
    return value_of(bicell_terms(detail::vectors<2>(z)), z.exponent);
}

}  // namespace annulus::inline v1
