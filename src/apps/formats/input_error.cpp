// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/input_error.h>

#include <utility>

namespace annulus::inline v1 {

namespace {

void append_escaped(std::string& out, unsigned char byte) {
    constexpr std::string_view digits = "0123456789abcdef";
    out += "\\x";
    out += digits[byte >> 4];
    out += digits[byte & 15];
}

/// A file name may hold line breaks and escape sequences; UTF-8 stays readable.
std::string on_one_line(std::string_view text) {
    std::string out;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte == 0x7f) append_escaped(out, byte);
        else out += c;
    }
    return out;
}

std::string message(std::string_view file, std::uint64_t line, std::string_view fault, std::string_view expected) {
    std::string out = on_one_line(file);
    if (line != 0) out += ":" + std::to_string(line);
    out += ": " + on_one_line(fault);
    if (!expected.empty()) out += "; expected " + on_one_line(expected);
    return out;
}

}  // namespace

Input_error::Input_error(Error_code code, std::string file, std::uint64_t line, std::string fault, std::string expected)
    : Error(code, message(file, line, fault, expected)),
      file_(std::move(file)),
      line_(line),
      fault_(std::move(fault)),
      expected_(std::move(expected)) {}

std::string shown(std::string_view text) {
    constexpr std::size_t longest = 40;
    std::string out = "'";
    for (const char c : text.substr(0, longest)) {
        const auto byte = static_cast<unsigned char>(c);
        if (byte < 0x20 || byte > 0x7e) append_escaped(out, byte);
        else out += c;
    }
    return out + (text.size() > longest ? "...'" : "'");
}

std::string counted(std::uint64_t count, std::string_view noun) {
    return std::to_string(count) + " " + std::string(noun) + (count == 1 ? "" : "s");
}

}  // namespace annulus::inline v1
