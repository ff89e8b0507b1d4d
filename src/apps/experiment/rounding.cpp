// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/experiment/rounding.h>

#include <annulus/error.h>
#include <apps/formats/decimal.h>

#include <array>
#include <charconv>
#include <cmath>

namespace annulus::inline v1 {

namespace {

template <class T>
std::optional<T> number(std::string_view word) {
    T value{};
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    if (error != std::errc() || stop != end) return std::nullopt;
    return value;
}

/// Rounds via the decimal text: x 10^k would be rounded once more.
double rounded_to_digits(double x, int digits) {
    std::array<char, 400> text{};  // 309 digits before the point at most
    const auto [end, error] =
        std::to_chars(text.data(), text.data() + text.size(), x, std::chars_format::fixed, digits);
    if (error != std::errc()) return x;
    double value = x;
    std::from_chars(text.data(), end, value);
    return value;
}

double rounded_to_float(double x) {
    const auto value = static_cast<double>(static_cast<float>(x));
    if (std::isinf(value))
        throw Error(Error_code::out_of_domain, "a coordinate is too large for a float: " + decimal(x));
    return value;
}

}  // namespace

std::optional<Rounding> rounding_named(std::string_view word) {
    const std::string name(word);
    if (word == "double") return Rounding{name};
    if (word == "float") return Rounding{name, Rounding::Kind::single};
    const std::size_t colon = word.find(':');
    if (colon == std::string_view::npos) return std::nullopt;
    const std::string_view kind = word.substr(0, colon), value = word.substr(colon + 1);
    if (kind == "decimal") {
        const auto digits = number<int>(value);
        if (digits && *digits >= 0 && *digits <= Rounding::most_digits)
            return Rounding{name, Rounding::Kind::decimal, *digits, 0};
    } else if (kind == "grid") {
        const auto spacing = number<double>(value);
        if (spacing && *spacing >= 1e-100 && *spacing <= 1e100)
            return Rounding{name, Rounding::Kind::grid, 0, *spacing};
    }
    return std::nullopt;
}

double rounded(double x, const Rounding& rounding) {
    switch (rounding.kind) {
        case Rounding::Kind::plain: return x;
        case Rounding::Kind::single: return rounded_to_float(x);
        case Rounding::Kind::decimal: return rounded_to_digits(x, rounding.digits);
        case Rounding::Kind::grid: return std::nearbyint(x / rounding.spacing) * rounding.spacing;
    }
    return x;
}

}  // namespace annulus::inline v1
