// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The check of one result by the fuzz targets of certificates, in 2D and in 3D.

#include "rational_3.h"

#include <annulus/predicate/half_width.h>

#include <cmath>
#include <string>

namespace annulus::oracle {

/// Whether a certificate value has one tolerance, or the least of several that other stages may have decided.
enum class Made_of : bool { one, several };

/// Empty, or the fault of a certificate value, given the truth.
[[nodiscard]] inline std::string fault_of(const Certificate_value& v, const Half_width_3& truth,
                                          Made_of made = Made_of::one) {
    if (v.sign != truth.sign()) return "sign";
    if (v.sign <= 0) return v.tolerance == 0.0 ? "" : "a tolerance without a sign";
    if (!(v.tolerance >= 0.0)) return "a tolerance that is negative or NaN";
    if (!truth.is_at_least(v.tolerance)) return "a tolerance above the truth";
    if (made == Made_of::one && v.stage == Stage::exact && truth.is_at_least(std::nextafter(v.tolerance, HUGE_VAL)))
        return "the exact stage is not the largest double";
    if (v.tolerance > 0x1p-1000 && truth.is_at_least(v.tolerance * 1.004)) return "a tolerance far below the truth";
    return {};
}
[[nodiscard]] inline std::string fault_of(const Half_width& h, const Half_width_3& truth) {
    if (truth.sign() <= 0) return h.upper == 0.0 ? "" : "an enclosure of what is 0";
    if (h.lower > 0.0 && !truth.is_at_least(h.lower)) return "a lower end above the truth";
    if (h.upper == 0.0) return "an enclosure that is 0";
    if (h.upper < HUGE_VAL && truth.is_at_least(h.upper) &&
        (h.stage == Stage::exact || truth.is_at_least(std::nextafter(h.upper, HUGE_VAL))))
        return "an upper end below the truth";
    return {};
}

}  // namespace annulus::oracle
