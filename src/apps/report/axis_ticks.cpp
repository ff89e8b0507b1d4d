// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/axis_ticks.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace annulus::inline v1 {

namespace {

/// 10 to the power n with a true minus and superscript digits.
std::string power_of_ten(int n) {
    static constexpr const char* digits[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    std::string out = "10";
    if (n < 0) out += "⁻";
    for (const char c : std::to_string(std::abs(n))) out += digits[c - '0'];
    return out;
}

std::string in_digits(double value, int decimals) {
    char text[800];  // room for any double; independent of the locale
    std::string out(text,
                    std::to_chars(text, text + sizeof text, std::fabs(value), std::chars_format::fixed, decimals).ptr);
    const auto dot = std::min(out.find('.'), out.size());
    for (std::size_t i = dot; i > 3;) {
        i -= 3;
        out.insert(i, ",");
    }
    return (value < 0 ? "−" : "") + out;
}

constexpr double least_ratio = 1.1;  // of the ends of a logarithmic axis: three digits tell its ticks apart

/// The step, 1, 2 or 5 times a power of ten, that divides the range into about five.
double nice_step(double range) {
    const double rough = range / 5;
    const double power = std::pow(10., std::floor(std::log10(rough)));
    const double lead = rough / power;
    return (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10) * power;
}

}  // namespace

Axis_range::Axis_range(const Axis& axis, const std::vector<double>& values) : scale_(axis.scale) {
    double lower = std::numeric_limits<double>::infinity();
    double upper = -lower;
    for (const double v : values) {
        if (!can_show(v)) continue;
        lower = std::min(lower, v);
        upper = std::max(upper, v);
    }
    const bool logarithmic = scale_ == Scale::log10;
    if (lower > upper) {  // nothing to show still gets a frame
        lower = logarithmic ? 0.1 : 0.;
        upper = 1;
    }
    lower_ = axis.lower && can_show(*axis.lower) ? *axis.lower : lower;
    upper_ = axis.upper && can_show(*axis.upper) ? *axis.upper : upper;
    // A range that is too narrow for doubles to count its ticks is shown like a single value.
    const double narrow = std::max(1e-280, 1e-9 * std::max(std::fabs(lower_), std::fabs(upper_)));
    if (logarithmic ? !(lower_ < upper_) : !(upper_ - lower_ > narrow)) {
        const double centre = lower_;
        lower_ = logarithmic ? centre / 3 : centre - std::max(std::fabs(centre) / 10, 1e-3);
        upper_ = logarithmic ? centre * 3 : centre + std::max(std::fabs(centre) / 10, 1e-3);
        if (logarithmic && axis.upper && *axis.upper == centre) upper_ = centre;
        if (!logarithmic && axis.lower) {  // for example counts that are all 0
            lower_ = centre;
            upper_ = centre + std::max(std::fabs(centre) / 10, 1.);
        }
    }
    if (!logarithmic) {
        make_linear(axis);
        return;
    }
    // Values that differ by less than the digits of a label.
    if (const double least = std::sqrt(least_ratio); upper_ / lower_ < least_ratio && !axis.tight) {
        const double centre = std::sqrt(lower_) * std::sqrt(upper_);
        if (!axis.lower) lower_ = centre / least;
        if (!axis.upper) upper_ = centre * least;
    }
    // Curves should not run along the frame, except over iterations, which begin exactly at 1.
    const double margin = std::pow(upper_ / lower_, 0.04);
    if (!axis.lower && !axis.tight) lower_ /= margin;
    if (!axis.upper && !axis.tight) upper_ *= margin;
    make_logarithmic();
}

void Axis_range::make_linear(const Axis& axis) {
    const double step = nice_step(upper_ - lower_);
    // Ends given by the caller are kept; those of the data move outwards to the next tick.
    if (!axis.lower) lower_ = std::floor(lower_ / step + 1e-9) * step;
    if (!axis.upper) upper_ = std::ceil(upper_ / step - 1e-9) * step;
    const double largest = std::max(std::fabs(lower_), std::fabs(upper_));
    const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(step) + 1e-9)), 0, 12);
    for (double i = std::ceil(lower_ / step - 1e-9); i * step <= upper_ + 1e-9 * step; ++i) {
        const double value = i * step;
        ticks_.push_back({value, i == 0                             ? "0"
                                 : largest < 1e-4 || largest >= 1e7 ? readable(value)
                                                                    : in_digits(value, decimals)});
    }
}

void Axis_range::make_logarithmic() {
    const int first = static_cast<int>(std::floor(std::log10(lower_) + 1e-9));
    const int last = static_cast<int>(std::ceil(std::log10(upper_) - 1e-9));
    const int every = std::max(1, (last - first + 5) / 6);  // label at most seven powers
    const bool in_digits_all = first >= -3 && last <= 5;    // one notation per axis
    const auto add = [&](double value, std::string label) {
        if (value >= lower_ * (1 - 1e-9) && value <= upper_ * (1 + 1e-9)) ticks_.push_back({value, std::move(label)});
    };
    for (int n = first; n <= last; ++n) {
        const double power = std::pow(10., n);
        const bool labelled = (n - first) % every == 0;
        add(power, !labelled ? "" : in_digits_all ? readable(power) : power_of_ten(n));
        if (last - first > 8) continue;
        for (int k = 2; k < 10; ++k)
            // An axis over less than two powers needs labels on the ticks between them.
            add(k * power, upper_ / lower_ < 100 && (k == 2 || k == 5) ? readable(k * power) : "");
    }
    const auto labelled =
        std::count_if(ticks_.begin(), ticks_.end(), [](const Tick& tick) { return !tick.label.empty(); });
    if (labelled >= 2) return;
    // Between two powers there is room for steps as on a linear axis.
    ticks_.clear();
    const double step = nice_step(upper_ - lower_);
    for (double i = std::ceil(lower_ / step - 1e-9); i * step <= upper_ + 1e-9 * step; ++i)
        add(i * step, readable(i * step));
}

double Axis_range::place(double value) const {
    if (scale_ == Scale::linear) return (value - lower_) / (upper_ - lower_);
    return (std::log10(value) - std::log10(lower_)) / (std::log10(upper_) - std::log10(lower_));
}

bool Axis_range::can_show(
    double value) const {  // Beyond these no margin or tick can be computed; no plot has such values.
    return std::fabs(value) <= 1e290 && (scale_ == Scale::linear || value >= 1e-290);
}

std::string readable(double value) {
    if (std::isnan(value)) return "–";
    if (std::isinf(value)) return value < 0 ? "−∞" : "∞";
    if (value == 0) return "0";
    char text[32];
    // Rounds to three digits before the exponent is read.
    const char* end = std::to_chars(text, text + sizeof text, value, std::chars_format::scientific, 2).ptr;
    double rounded = value;
    std::from_chars(text, end, rounded);
    const int exponent = static_cast<int>(std::floor(std::log10(std::fabs(rounded)) + 1e-9));
    if (exponent >= 7 || exponent < -4) {
        const double lead = rounded / std::pow(10., exponent);
        std::string digits = in_digits(lead, 2);
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.ends_with('.')) digits.pop_back();
        return (digits == "1" ? "" : digits + "·") + power_of_ten(exponent);
    }
    std::string digits = in_digits(rounded, std::max(0, 2 - exponent));
    if (digits.find('.') != std::string::npos) {
        digits.erase(digits.find_last_not_of('0') + 1);
        if (digits.ends_with('.')) digits.pop_back();
    }
    return digits;
}

std::string grouped(std::uint64_t value) {
    std::string out = std::to_string(value);
    for (std::size_t i = out.size(); i > 3;) {
        i -= 3;
        out.insert(i, ",");
    }
    return out;
}

std::string grouped(std::uint64_t value, std::string_view noun) {
    return grouped(value) + " " + std::string(noun) + (value == 1 ? "" : "s");
}

std::string none_or(std::uint64_t value) { return value == 0 ? "none" : grouped(value); }

}  // namespace annulus::inline v1
