// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/bounds.h>
#include <annulus/predicate/certificate_value.h>
#include <annulus/predicate/width_terms.h>
#include <annulus/predicate/width_terms_3.h>

#include <algorithm>
#include <cmath>
#include <concepts>

// The filter stage on a number type V: a double, or several of them side by side (lanes.h). Both use one formula with
// the same operations, so a batch gives the same bits as single calls.
namespace annulus::inline v1::detail {

template <class Mask, class V>
[[nodiscard]] V select(const Mask& choose, const V& yes, const V& no) {
    if constexpr (std::same_as<Mask, bool>) {
        return choose ? yes : no;
    } else {
        V result = no;
        where(choose, result) = yes;
        return result;
    }
}

/// True if at least one lane is.
template <class Mask>
[[nodiscard]] bool any(const Mask& mask) {
    if constexpr (std::same_as<Mask, bool>) return mask;
    else return any_of(mask);
}

template <class V>
[[nodiscard]] V magnitude(const Vector_2<V>& v) {
    using std::abs;
    using std::max;
    return max(V(abs(v.x)), V(abs(v.y)));
}
template <class V>
[[nodiscard]] V magnitude(const Vector_3<V>& v) {
    using std::abs;
    using std::max;
    return max(V(max(V(abs(v.x)), V(abs(v.y)))), V(abs(v.z)));
}

/// What the filter stage decides about one certificate.
template <class V>
struct Decision {
    V sign;       ///< 1 or -1; 0: left to the next stage
    V tolerance;  ///< lower bound of half the width; meaningless unless sign is 1
};

/// Decides from a computed determinant and computed norms, if with the error bounds the sign is certain and the
/// tolerance tight.
///
/// `det_error` bounds |determinant~ - determinant|, and `norm_error` by how much the computed roots may be too small,
/// both absolute. With certified = false the tolerance is the plain quotient and only the sign is decided here.
/// Proved: proofs/gappa/tail_2.g, tail_3.g.
template <class V>
[[nodiscard]] Decision<V> decide(const V& determinant, const V& roots, const V& det_error, const V& norm_error,
                                 bool certified) {
    const auto negative = determinant < -det_error;
    auto positive = determinant * V(bounds::filter_slack) > det_error;
    V tolerance;
    if (certified) {
        positive = positive && roots * V(bounds::filter_slack) > norm_error;
        tolerance = (determinant - det_error) / (roots + norm_error) * V(1.0 - bounds::tail * bounds::u);
    } else {
        tolerance = determinant / roots;
    }
    return {select(negative, V(-1.0), select(positive, V(1.0), V(0.0))), tolerance};
}

/// `l` where `needed` is false or l is negative; otherwise both must be positive, and the tolerance is the lesser one.
template <class V, class Mask>
[[nodiscard]] Decision<V> both(const Decision<V>& l, const Decision<V>& r, const Mask& needed) {
    using std::min;
    const auto undecided = needed && l.sign > V(0.0) && !(r.sign > V(0.0));
    return {select(undecided, V(0.0), l.sign), select(needed, V(min(l.tolerance, r.tolerance)), l.tolerance)};
}

/// `decision`, but undecided where it is positive and in doubt.
template <class V, class Mask>
[[nodiscard]] Decision<V> unless(const Decision<V>& decision, const Mask& doubt) {
    return {select(doubt && decision.sign > V(0.0), V(0.0), decision.sign), decision.tolerance};
}

/// `decision` where the largest difference m is in the range of the bounds, 1 / range to range; elsewhere undecided.
template <class V>
[[nodiscard]] Decision<V> in_range(const V& m, double range, const Decision<V>& decision) {
    const auto inside = m <= V(range) && m * V(range) >= V(1.0);
    return {select(inside, decision.sign, V(0.0)), decision.tolerance};
}

/// Stores one lane as a value. Returns false if the next stage has to decide.
[[nodiscard]] inline bool answer(double sign, double tolerance, Certificate_value& out) {
    out.stage = Stage::filter;
    out.sign = static_cast<std::int8_t>(sign);
    out.tolerance = sign > 0.0 ? tolerance : 0.0;
    return sign != 0.0;
}

}  // namespace annulus::inline v1::detail
