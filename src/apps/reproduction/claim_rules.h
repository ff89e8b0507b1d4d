// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/reproduction/claims.h>

#include <vector>

// How verdicts follow from numbers. A claim is met by some values, and what was measured is an interval: the claim
// agrees where the whole interval meets it, differs where nothing of it does, and is open otherwise.
namespace annulus::inline v1 {

/// `low` <= `high`.
struct Measured {
    double low = 0, high = 0;
};
/// From the least value to the greatest. There has to be one.
[[nodiscard]] Measured measured(const std::vector<double>& values);
/// The mean, less and more the standard deviation (0 for one value). There has to be one.
[[nodiscard]] Measured scattered(const std::vector<double>& values);

/// Whether it is from `from` to `to`.
[[nodiscard]] Claim_verdict within(Measured x, double from, double to);
/// Whether it is below the other: open where the intervals overlap.
[[nodiscard]] Claim_verdict below(Measured x, Measured other);
/// Whether a count became smaller: open unless the difference is more than the square root of their sum, as counts of
/// independent events scatter.
[[nodiscard]] Claim_verdict fewer(double before, double after);
/// Whether ratios of times are above 1, in every run. Times scatter: a ratio within 3 % of 1 is neither above nor
/// below.
[[nodiscard]] Claim_verdict above_one(const std::vector<double>& ratios);
/// Of a claim that can be read in two ways, or that was measured in two: open where the verdicts are not the same.
[[nodiscard]] Claim_verdict both(Claim_verdict a, Claim_verdict b);
/// Of a claim of several parts, or of every run: differs where one of them does, agrees where each agrees.
[[nodiscard]] Claim_verdict every(const std::vector<Claim_verdict>& parts);
[[nodiscard]] inline Claim_verdict agree_if(bool yes) { return yes ? Claim_verdict::agrees : Claim_verdict::differs; }
/// Of a claim of a bound, "up to" or "at least", and of no other: nine tenths of it agree, twice as much goes further.
[[nodiscard]] Claim_verdict at_least(double value, double claimed);

/// These rules in words, for pages.
[[nodiscard]] const char* claim_rules();

}  // namespace annulus::inline v1
