// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/formats/input_error.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace annulus {

/// A file in memory and the name to use for it in messages. A leading UTF-8 byte order mark is gone from `content`.
struct Source {
    std::string name;
    std::string content;
};

/// Reads a whole file, unpacked where its name ends in .gz. Throws Input_error when it is missing, a directory, unreadable
/// or empty, and when what is packed in it is damaged, cut off, or more than 64 MiB and a hundred times the file.
[[nodiscard]] Source load_file(const std::filesystem::path& file);

/// What a decimal number turned out to be.
enum class Number_kind { finite, not_a_number, nan, too_large };

/// Decimal to double, correctly rounded (to nearest) and independent of the locale; a leading + is accepted, anything
/// after the number is not. Magnitudes too small for a double give zero, infinities and those too large are
/// `too_large`.
[[nodiscard]] Number_kind parse_double(std::string_view text, double& value) noexcept;

/// Walks over the lines of a text and splits them into fields. LF and CRLF both end a line.
///
/// Every fault is reported by `fail` with the number of the current line; past the end it stays on the last line. The
/// content must outlive the reader.
class Line_reader {
  public:
    explicit Line_reader(const Source& source) : name_(source.name), rest_(source.content) {}

    /// Goes to the next line; false at the end of the file, where the fields are empty.
    bool next_line();

    /// Goes to the next line that is neither blank nor a comment and splits it at white space; # starts a comment.
    bool next_record();

    /// The current line without its end.
    [[nodiscard]] std::string_view line() const noexcept { return line_; }
    /// Number of the current line, from 1; 0 before the first.
    [[nodiscard]] std::uint64_t number() const noexcept { return number_; }
    [[nodiscard]] const std::vector<std::string_view>& fields() const noexcept { return fields_; }
    /// All that follows the current line.
    [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    [[noreturn]] void fail(std::string fault, std::string expected, Error_code code = Error_code::bad_input) const;
    /// The same of a line read before.
    [[noreturn]] void fail_at(std::uint64_t line, std::string fault, std::string expected,
                              Error_code code = Error_code::bad_input) const;

    /// `text` as a finite double; `what` names it in the fault ("x").
    [[nodiscard]] double real(std::string_view text, std::string_view what) const;

    /// `text` as an integer of 0 or more that fits in 64 bits.
    [[nodiscard]] std::uint64_t whole(std::string_view text, std::string_view what) const;

    /// How many of `count` records to make room for: no more than the rest of the file can hold at `bytes` bytes each
    /// (end of line included), so that a wrong count never decides how much memory is asked for. Fails when there are
    /// more than an Index can number.
    [[nodiscard]] std::size_t room_for(std::uint64_t count, std::uint64_t bytes, std::string_view noun) const;

    /// Goes to the next record, the one after `done` of `count`; fails when the file ends first.
    void require_record(std::uint64_t done, std::uint64_t count, std::string_view noun);

  private:
    std::string name_;
    std::string_view rest_;
    std::string_view line_;
    std::uint64_t number_ = 0;
    std::vector<std::string_view> fields_;
};

}  // namespace annulus
