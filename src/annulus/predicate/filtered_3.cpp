// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/predicate/filtered_3.h>

#include <annulus/arithmetic/exact.h>
#include <annulus/predicate/integer_signs.h>
#include <annulus/predicate/interval_stage.h>

#include <optional>

namespace annulus::inline v1 {

namespace {

// vector(i, j) is point i minus point j.
template <class Vectors>
auto tetrahedron_terms(const Vectors& vector) {
    return orientation_terms(vector(1, 0), vector(2, 0), vector(3, 0));
}
template <class Vectors>
auto bicell_terms(const Vectors& vector) {
    return annulus_terms(vector(1, 0), vector(2, 0), vector(3, 0), vector(4, 0));
}

// ---- Interval stage ---------------------------------------------------------------------------------------------

/// Half the width of a tetrahedron, scaled. Returns false where it is not certainly positive or not tight.
bool width_lower(const Width_terms<Interval>& t, double& lower) {
    if (!(t.determinant.lower() > 0.0)) return false;
    return detail::quotient_lower_in_slack(t.determinant, detail::roots_upper(t.inner, t.outer),
                                           detail::roots_about(t.inner, t.outer), lower);
}

// ---- Exact stage ------------------------------------------------------------------------------------------------

/// Half a width as the largest double not above it; 0 where the determinant is not positive.
double half_width(const Width_terms<mpz_class>& t, long exponent) {
    return sgn(t.determinant) > 0 ? quotient_by_roots_lower(t.determinant, t.inner, t.outer, exponent) : 0.0;
}

struct Exact_bicell {
    Bicell_terms_3<mpz_class> terms;
    long exponent;

    explicit Exact_bicell(const Tuple<3, 5>& x) {
        const Scaled_integers z(coordinates(x));
        terms = bicell_terms(detail::vectors<3>(z));
        exponent = z.exponent;
    }
    [[nodiscard]] double half_width_of(std::size_t k) const {
        return half_width({mpz_class(abs(terms.determinant)), terms.inner[k], terms.outer[k]}, exponent);
    }
};

}  // namespace

bool orientation_interval(const Tuple<3, 4>& x, Certificate_value& out) {
    return detail::with_scale(x, [&](const auto& minus, const detail::Scale& s) {
        const auto t = tetrahedron_terms(detail::vectors(x, minus));
        if (!detail::interval_sign(t.determinant, out)) return false;
        if (out.sign < 0) return true;
        double lower = 0.0;
        if (!width_lower(t, lower)) return false;
        out.tolerance = detail::unscaled_lower(lower, s);
        return true;
    });
}

bool empty_sphere_interval(const Tuple<3, 5>& x, Certificate_value& out, Cell_widths cells) {
    return detail::with_scale(x, [&](const auto& minus, const detail::Scale& s) {
        const auto t = bicell_terms(detail::vectors(x, minus));
        out.wrong_side = 0;
        bool certainly = false;  // one partition is on the wrong side
        for (std::size_t k = 1; k < partitions_3; ++k) {
            if (!(t.side[k].lower() > 0.0)) out.wrong_side = static_cast<std::uint8_t>(out.wrong_side | (1U << k));
            certainly = certainly || t.side[k].upper() <= 0.0;
        }
        if (!detail::interval_sign(t.determinant, out)) return false;
        if (out.sign < 0) return true;
        double most = 0.0;
        double least = 0.0;
        for (std::size_t k = 0; k < partitions_3; ++k) {
            most = std::max(most, detail::roots_upper(t.inner[k], t.outer[k]));
            least = std::max(least, detail::roots_about(t.inner[k], t.outer[k]));
        }
        double lower = 0.0;
        if (!detail::quotient_lower_in_slack(t.determinant, most, least, lower)) return false;
        if (cells == Cell_widths::always || (cells == Cell_widths::where_needed && out.wrong_side != 0)) {
            double p = 0.0;
            double q = 0.0;
            if (!width_lower(cell_p_terms(t), p) || !width_lower(cell_q_terms(t), q)) return false;
            if (cells == Cell_widths::where_needed && !certainly && std::min(p, q) < lower) return false;
            lower = std::min(lower, std::min(p, q));
        }
        out.tolerance = detail::unscaled_lower(lower, s);
        return true;
    });
}

Certificate_value orientation_exact(const Tuple<3, 4>& x) {
    const std::optional<int> sign = integer_orientation<3>(scaled_points(x));
    if (sign && *sign <= 0) return {0.0, static_cast<std::int8_t>(*sign), Stage::exact};  // it has no tolerance
    const Scaled_integers z(coordinates(x));
    const auto t = tetrahedron_terms(detail::vectors<3>(z));
    Certificate_value out;
    out.stage = Stage::exact;
    out.sign = static_cast<std::int8_t>(sgn(t.determinant));
    out.tolerance = half_width(t, z.exponent);
    return out;
}

Certificate_value empty_sphere_exact(const Tuple<3, 5>& x, Cell_widths cells) {
    Certificate_value out;
    out.stage = Stage::exact;
    const auto note_side = [&out](std::size_t k, int sign) {
        if (sign <= 0) out.wrong_side = static_cast<std::uint8_t>(out.wrong_side | (1U << k));
    };
    if (const auto signs = integer_bicell(scaled_points(x)); signs && signs->sphere <= 0) {
        out.sign = static_cast<std::int8_t>(signs->sphere);
        for (std::size_t k = 1; k < partitions_3; ++k) note_side(k, signs->side[k - 1]);
        return out;
    }
    const Exact_bicell e(x);
    out.sign = static_cast<std::int8_t>(sgn(e.terms.determinant));
    for (std::size_t k = 1; k < partitions_3; ++k) note_side(k, sgn(e.terms.side[k]));
    if (out.sign <= 0) return out;
    out.tolerance = e.half_width_of(0);
    for (std::size_t k = 1; k < partitions_3; ++k) out.tolerance = std::min(out.tolerance, e.half_width_of(k));
    if (cells == Cell_widths::always || (cells == Cell_widths::where_needed && out.wrong_side != 0))
        out.tolerance = std::min({out.tolerance, half_width(cell_p_terms(e.terms), e.exponent),
                                  half_width(cell_q_terms(e.terms), e.exponent)});
    return out;
}

Annuli annuli_exact(const Tuple<3, 5>& x) {
    const Exact_bicell e(x);
    Annuli out;
    out.sign = static_cast<std::int8_t>(sgn(e.terms.determinant));
    for (std::size_t k = 0; k < partitions_3; ++k) {
        out.side[k] = static_cast<std::int8_t>(sgn(e.terms.side[k]));
        out.half_width[k] = e.half_width_of(k);
    }
    return out;
}

}  // namespace annulus::inline v1
