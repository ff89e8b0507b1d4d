// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/decimal.h>

#include <charconv>

namespace annulus::inline v1 {

void append_decimal(std::string& out, double value) {
    char digits[32];  // 24 are enough for any double
    out.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

std::string decimal(double value) {
    std::string out;
    append_decimal(out, value);
    return out;
}

}  // namespace annulus::inline v1
