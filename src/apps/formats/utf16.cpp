// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/utf16.h>

#include <utility>

namespace annulus::inline v1 {

namespace {

void append_utf8(std::string& out, unsigned code) {
    const auto byte = [&out](unsigned value) { out += static_cast<char>(static_cast<unsigned char>(value)); };
    if (code < 0x80) return byte(code);
    if (code < 0x800) {
        byte(0xc0 | code >> 6);
        return byte(0x80 | (code & 0x3f));
    }
    if (code < 0x10000) {
        byte(0xe0 | code >> 12);
    } else {
        byte(0xf0 | code >> 18);
        byte(0x80 | (code >> 12 & 0x3f));
    }
    byte(0x80 | (code >> 6 & 0x3f));
    byte(0x80 | (code & 0x3f));
}

}  // namespace

Utf16_decoder::Utf16_decoder(std::string_view begin) noexcept
    : little_(begin.starts_with("\xff\xfe") || (!begin.starts_with("\xfe\xff") && begin.size() > 1 && begin[1] == 0)) {}

bool Utf16_decoder::take(unsigned unit, std::string& utf8) {
    const bool low = unit >= 0xdc00 && unit < 0xe000;
    if (low != (high_ != 0)) return false;
    if (low) append_utf8(utf8, 0x10000 + ((std::exchange(high_, 0) - 0xd800) << 10) + (unit - 0xdc00));
    else if (unit >= 0xd800 && unit < 0xdc00) high_ = unit;
    else append_utf8(utf8, unit);
    return true;
}

bool Utf16_decoder::append(std::string_view bytes, std::string& utf8) {
    for (const char c : bytes) {
        rest_ += c;
        if (rest_.size() < 2) continue;
        const auto first = static_cast<unsigned char>(rest_[0]), second = static_cast<unsigned char>(rest_[1]);
        rest_.clear();
        if (!take(little_ ? first | unsigned{second} << 8 : second | unsigned{first} << 8, utf8)) return false;
    }
    return true;
}

}  // namespace annulus::inline v1
