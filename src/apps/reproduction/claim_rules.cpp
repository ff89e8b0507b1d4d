// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/reproduction/claim_rules.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

Measured measured(const std::vector<double>& values) {
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    return {*low, *high};
}

Measured scattered(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    double mean = 0, squares = 0;
    for (const double x : values) mean += x / n;
    for (const double x : values) squares += (x - mean) * (x - mean);
    const double deviation = n > 1 ? std::sqrt(squares / (n - 1)) : 0;
    return {mean - deviation, mean + deviation};
}

Claim_verdict within(Measured x, double from, double to) {
    if (x.low >= from && x.high <= to) return Claim_verdict::agrees;
    return x.high < from || x.low > to ? Claim_verdict::differs : Claim_verdict::open;
}

Claim_verdict below(Measured x, Measured other) {
    if (x.high < other.low) return Claim_verdict::agrees;
    return x.low >= other.high ? Claim_verdict::differs : Claim_verdict::open;
}

Claim_verdict fewer(double before, double after) {
    if (std::fabs(before - after) <= std::sqrt(before + after)) return Claim_verdict::open;
    return agree_if(after < before);
}

Claim_verdict above_one(const std::vector<double>& ratios) {
    constexpr double noise = 0.03;
    std::vector<Claim_verdict> runs;
    for (const double x : ratios)
        runs.push_back(x >= 1 + noise   ? Claim_verdict::agrees
                       : x <= 1 - noise ? Claim_verdict::differs
                                        : Claim_verdict::open);
    return every(runs);
}

Claim_verdict both(Claim_verdict a, Claim_verdict b) { return a == b ? a : Claim_verdict::open; }

Claim_verdict every(const std::vector<Claim_verdict>& parts) {
    const auto has = [&](Claim_verdict v) { return std::find(parts.begin(), parts.end(), v) != parts.end(); };
    if (has(Claim_verdict::differs)) return Claim_verdict::differs;
    return parts.empty() || has(Claim_verdict::open) ? Claim_verdict::open : Claim_verdict::agrees;
}

Claim_verdict at_least(double value, double claimed) {
    return value >= 2 * claimed ? Claim_verdict::further : agree_if(value >= 0.9 * claimed);
}

const char* claim_rules() {
    return "Verdicts follow from numbers by one rule. A claim is met by some values: a number of the paper stands for "
           "those near it, as said beside each. What was measured is an interval, from the least value of the runs to "
           "the greatest or, where a mean is claimed, from the mean less the standard deviation to the mean and that "
           "much more. The claim agrees where the whole interval meets it, differs where nothing of it does, and is "
           "open where a part does, where two readings of the paper have different verdicts, or where it was not run. "
           "A claim of every run differs where one run contradicts it, and a claim of several parts where one part "
           "does. Times whose ratio is within 3 % of 1 count as equal, and leave open which is longer. Of a bound, "
           "\"up to\" or \"at least\" so much, nine tenths agree, and what is found goes further where it is twice the "
           "bound or more; any other number differs where more is found than what is said beside it. A claim is wrong "
           "where exact arithmetic refutes it.";
}

}  // namespace annulus::inline v1
