// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/parse_double.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <system_error>

namespace annulus::inline v1 {

namespace {

constexpr bool is_decimal_digit(char c) noexcept { return c >= '0' && c <= '9'; }

/// For a decimal that from_chars calls out of range, too large or too small: whether its magnitude is at least 1.
bool is_large(std::string_view text) noexcept {
    long long exponent = 0;  // of ten, of the first digit that is not zero
    bool seen = false;
    bool fraction = false;
    std::size_t i = 0;
    for (; i < text.size() && text[i] != 'e' && text[i] != 'E'; ++i) {
        if (text[i] == '.') fraction = true;
        if (!is_decimal_digit(text[i])) continue;
        if (fraction && !seen) --exponent;
        if (!fraction && seen) ++exponent;
        seen = seen || text[i] != '0';
    }
    if (i == text.size()) return exponent >= 0;
    ++i;
    const bool negative = i < text.size() && text[i] == '-';
    if (i < text.size() && (text[i] == '-' || text[i] == '+')) ++i;
    long long written = 0;
    // Saturates far beyond any length a file can have, so the sum below cannot overflow.
    for (; i < text.size(); ++i) written = std::min(written * 10 + (text[i] - '0'), 1LL << 58);
    return exponent + (negative ? -written : written) >= 0;
}

/// Characters that a number in another notation may have.
constexpr std::size_t longest_foreign = 64;

/// Where Fortran's exponent of a decimal begins, as in 1.5D+01 and 1.5-101: at the D, or at the sign of three digits.
std::optional<std::size_t> fortran_exponent(std::string_view text) noexcept {
    const std::size_t d = text.find_first_of("dD");
    if (d != std::string_view::npos && d > 0) return d;
    if (text.size() < 5) return std::nullopt;
    const std::size_t sign = text.size() - 4;
    if (text[sign] != '+' && text[sign] != '-') return std::nullopt;
    // Fortran writes a point; 2024-101 is something else.
    return text.substr(0, sign).find('.') != std::string_view::npos ? std::optional(sign) : std::nullopt;
}

Number_kind parse_c_double(std::string_view text, double& value) noexcept {
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code == std::errc::invalid_argument || end != text.data() + text.size()) return Number_kind::not_a_number;
    if (code == std::errc::result_out_of_range) {
        if (is_large(text)) return Number_kind::too_large;
        value = text[0] == '-' ? -0. : 0.;
        return Number_kind::finite;
    }
    if (std::isnan(value)) return Number_kind::nan;
    return std::isinf(value) ? Number_kind::too_large : Number_kind::finite;
}

}  // namespace

Number_kind parse_double(std::string_view text, double& value) noexcept {
    if (text.size() > 1 && text[0] == '+' && (is_decimal_digit(text[1]) || text[1] == '.')) text.remove_prefix(1);
    const Number_kind kind = parse_c_double(text, value);
    if (kind != Number_kind::not_a_number || text.size() > longest_foreign) return kind;
    const auto exponent = fortran_exponent(text);
    if (!exponent) return kind;
    const bool letter = !is_decimal_digit(text[*exponent]) && text[*exponent] != '+' && text[*exponent] != '-';
    std::array<char, longest_foreign + 1> c{};
    auto out = std::copy_n(text.begin(), *exponent, c.begin());
    *out++ = 'e';
    const std::string_view rest = text.substr(*exponent + (letter ? 1 : 0));
    out = std::copy(rest.begin(), rest.end(), out);
    return parse_c_double({c.data(), static_cast<std::size_t>(out - c.begin())}, value);
}

}  // namespace annulus::inline v1
