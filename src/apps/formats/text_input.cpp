// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/types.h>
#include <apps/formats/file_bytes.h>
#include <apps/formats/text_input.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr bool is_blank(char c) noexcept { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// The line end of a text, decided by its first line, which is searched from a position on; 0 where the line may still
/// continue. It is CR where no LF comes after it.
char line_end_of(std::string_view text, std::size_t from, bool whole) {
    const std::size_t at = text.find_first_of("\r\n", from);
    if (at == std::string_view::npos) return whole ? '\n' : '\0';
    if (text[at] == '\n') return '\n';
    if (at + 1 == text.size()) return whole ? '\r' : '\0';
    return text[at + 1] == '\n' ? '\n' : '\r';
}

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";
constexpr std::size_t longest_line = std::size_t{64} << 20;

}  // namespace

void require_no_bomb(const File_bytes& bytes, std::uint64_t unpacked, std::uint64_t line) {
    constexpr std::uint64_t free = std::uint64_t{64} << 20, ratio = 100;
    if (bytes.packed() && unpacked > free + ratio * bytes.taken())
        throw Input_error(Error_code::bad_input, bytes.name(), line,
                          "grows to more than " + std::to_string(ratio) + " times its size",
                          "text, or the file as it is when unpacked");
}

Source load_file(const std::filesystem::path& file, std::uint64_t most) {
    File_bytes bytes(file);
    return load_file(bytes, most);
}

std::uint64_t bound_of(const File_bytes& bytes, std::uint64_t most) {
    return bytes.size() ? most : std::min(most, most_of_a_pipe);
}

Source load_file(File_bytes& bytes, std::uint64_t most) {
    Source source{bytes.name(), {}};
    const std::uint64_t bound = bound_of(bytes, most);
    const auto require_bounded = [&](std::uint64_t size) {
        if (size > bound)
            throw Input_error(Error_code::bad_input, source.name, 0,
                              "has more than " + std::to_string(bound) + " bytes", "fewer");
    };
    require_bounded(bytes.size().value_or(0));
    source.content.reserve(static_cast<std::size_t>(bytes.size().value_or(0)));
    while (bytes.more(source.content)) {
        require_no_bomb(bytes, source.content.size(), 0);
        require_bounded(source.content.size());
    }
    if (source.content.starts_with(byte_order_mark)) source.content.erase(0, byte_order_mark.size());
    if (source.content.empty()) throw Input_error(Error_code::bad_input, source.name, 1, "is empty", "data");
    return source;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& words) {
    words.clear();
    for (std::size_t i = 0; i < line.size();) {
        if (is_blank(line[i])) {
            ++i;
            continue;
        }
        const std::size_t begin = i;
        while (i < line.size() && !is_blank(line[i])) ++i;
        words.push_back(line.substr(begin, i - begin));
    }
}

Line_reader::Line_reader(File_bytes& bytes) : name_(bytes.name()), bytes_(&bytes) { bytes.accept(Foreign::utf16); }

/// Appends the next block to the buffer; false at the end.
bool Line_reader::more() {
    if (ended_) return false;
    const std::size_t before = buffer_.size();
    try {
        ended_ = !bytes_->more(buffer_);
        unpacked_ += buffer_.size() - before;
        require_no_bomb(*bytes_, unpacked_ - piece_, 0);
    } catch (const Input_error& error) {
        fail_at(number_ + 1, error.fault(), error.expected(), error.code());
    }
    return !ended_;
}

/// Reads on until the buffer has a whole line; returns the position of its end.
std::size_t Line_reader::read_line_end() {
    buffer_.erase(0, buffer_.size() - rest_.size());
    if (unpacked_ == 0) {
        while (buffer_.size() < byte_order_mark.size() && more()) continue;
        if (buffer_.starts_with(byte_order_mark)) buffer_.erase(0, byte_order_mark.size());
        if (buffer_.empty() && !more()) fail_at(1, "is empty", "data");
    }
    std::size_t searched = 0, end = std::string::npos;
    while (true) {
        if (end_ == '\0') end_ = line_end_of(buffer_, searched, ended_);
        if (end_ != '\0' && (end = buffer_.find(end_, searched)) != std::string::npos) break;
        searched = buffer_.size();
        if (searched > longest_line) fail_at(number_ + 1, "is longer than 64 MiB", "a line of numbers");
        if (end_ == '\0' && buffer_.ends_with('\r')) --searched;
        if (!more()) break;
    }
    rest_ = buffer_;
    return end;
}

bool Line_reader::next_line() {
    fields_.clear();
    line_ = {};
    if (end_ == '\0' && bytes_ == nullptr) end_ = line_end_of(rest_, 0, true);
    std::size_t end = end_ == '\0' ? std::string_view::npos : rest_.find(end_);
    if (end == std::string_view::npos && bytes_ != nullptr) end = read_line_end();
    if (rest_.empty()) return false;
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    ++number_;
    if (end_ == '\r' && line_.find('\n') != std::string_view::npos)
        fail("lines end by CR, and here by LF", "one of the two");
    if (line_.ends_with('\r')) line_.remove_suffix(1);
    return true;
}

bool Line_reader::next_record() {
    while (next_line()) {
        split_at_blanks(line_.substr(0, line_.find('#')), fields_);
        if (!fields_.empty()) return true;
    }
    return false;
}

void Line_reader::fail(std::string fault, std::string expected, Error_code code) const {
    fail_at(number_, std::move(fault), std::move(expected), code);
}

void Line_reader::fail_at(std::uint64_t line, std::string fault, std::string expected, Error_code code) const {
    throw Input_error(code, name_, std::max<std::uint64_t>(line, 1), std::move(fault), std::move(expected));
}

double Line_reader::real(std::string_view text, std::string_view what) const {
    double value = 0;
    const std::string name(what);
    if (text.empty()) fail(name + " is missing", "a number");
    switch (parse_double(text, value)) {
        case Number_kind::finite: return value;
        case Number_kind::not_a_number: fail(name + " is not a number: " + shown(text), "a number");
        case Number_kind::nan: fail(name + " is nan: " + shown(text), "a finite number", Error_code::not_finite);
        case Number_kind::too_large: break;
    }
    fail(name + " is infinite or too large for a double: " + shown(text), "a finite number", Error_code::not_finite);
}

std::uint64_t Line_reader::whole(std::string_view text, std::string_view what) const {
    std::uint64_t value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code == std::errc::result_out_of_range && end == text.data() + text.size())
        fail(std::string(what) + " is too large: " + shown(text), "an integer below 2^64");
    if (code != std::errc() || end != text.data() + text.size())
        fail(std::string(what) + " is not an integer of 0 or more: " + shown(text), "an integer of 0 or more");
    return value;
}

std::size_t Line_reader::room_for(std::uint64_t count, std::uint64_t bytes, std::string_view noun) const {
    if (count > static_cast<std::uint64_t>(std::numeric_limits<Index>::max()))
        fail("says " + std::to_string(count) + " " + std::string(noun), "fewer than 2^31");
    // One byte more than the rest, because the last line may have no end.
    return static_cast<std::size_t>(std::min(count, (static_cast<std::uint64_t>(rest_.size()) + 1) / bytes));
}

void Line_reader::require_record(std::uint64_t done, std::uint64_t count, std::string_view noun) {
    if (next_record()) return;
    fail("the file ends after " + std::to_string(done) + " of " + std::to_string(count) + " " + std::string(noun),
         std::to_string(count - done) + " more");
}

}  // namespace annulus::inline v1
