// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/formats/input_error.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace annulus {

class File_bytes;

/// A file in memory and the name to use for it in messages. A leading UTF-8 byte order mark is gone from `content`.
struct Source {
    std::string name;
    std::string content;
};

/// What a pipe may bring for a reader that holds all of it, and a bound for pictures: none has more pixels than fit.
inline constexpr std::uint64_t most_of_a_pipe = std::uint64_t{1} << 30;

/// How many bytes of it load_file takes that is told `most`: of what is no regular file, and may have no end,
/// most_of_a_pipe at most.
[[nodiscard]] std::uint64_t bound_of(const File_bytes& bytes, std::uint64_t most);

/// Reads a whole file, unpacked where it is packed. Throws Input_error when it is missing, a directory, unreadable or
/// empty, when what is packed in it is damaged, cut off, or more than 64 MiB and a hundred times the file, and when
/// it has more than bound_of(file, most) bytes.
[[nodiscard]] Source load_file(const std::filesystem::path& file,
                               std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
[[nodiscard]] Source load_file(File_bytes& bytes, std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// What a decimal number turned out to be.
enum class Number_kind { finite, not_a_number, nan, too_large };

/// Decimal to double, correctly rounded (to nearest) and independent of the locale; a leading + is accepted, anything
/// after the number is not. Magnitudes too small for a double give zero, infinities and those too large are
/// `too_large`.
[[nodiscard]] Number_kind parse_double(std::string_view text, double& value) noexcept;

/// The words of a line between blanks.
void split_at_blanks(std::string_view line, std::vector<std::string_view>& words);

/// Walks over the lines of a text and splits them into fields. LF and CRLF both end a line; CR alone, as old programs
/// write it, in a text whose first line ends so. A text that ends some lines by CR and others by LF is a fault.
///
/// The text is in memory, or a file that is read as lines are asked for: then no more of it is held than the line and
/// a block, what File_bytes finds is a fault of the line that is due, and a line of more than 64 MiB is one. Every
/// fault is reported by `fail` with the number of the current line; past the end it stays on the last line. The text
/// must outlive the reader.
class Line_reader {
  public:
    explicit Line_reader(const Source& source) : name_(source.name), rest_(source.content) {}
    /// Nothing is read before it is asked for. A leading byte order mark is stepped over, an empty file is a fault.
    explicit Line_reader(File_bytes& bytes);
    Line_reader(const Line_reader&) = delete;  // views of its own text
    Line_reader& operator=(const Line_reader&) = delete;

    /// What is read from here on is kept by the caller until this is called again: where it is packed, 64 MiB and a
    /// hundred times the file are a bound for it.
    void begin_piece() noexcept { piece_ = unpacked_; }

    /// Goes to the next line; false at the end of the file, where the fields are empty.
    bool next_line();

    /// Goes to the next line that is neither blank nor a comment and splits it at white space; # starts a comment.
    bool next_record();

    /// The current line without its end.
    [[nodiscard]] std::string_view line() const noexcept { return line_; }
    /// Number of the current line, from 1; 0 before the first.
    [[nodiscard]] std::uint64_t number() const noexcept { return number_; }
    [[nodiscard]] const std::vector<std::string_view>& fields() const noexcept { return fields_; }
    /// All that follows the current line in a text in memory.
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

    /// How many of `count` records to make room for: no more than the rest of the file, as far as it is in memory,
    /// can hold at `bytes` bytes each (end of line included), so that a wrong count never decides how much memory is
    /// asked for. Fails when there are more than an Index can number.
    [[nodiscard]] std::size_t room_for(std::uint64_t count, std::uint64_t bytes, std::string_view noun) const;

    /// Goes to the next record, the one after `done` of `count`; fails when the file ends first.
    void require_record(std::uint64_t done, std::uint64_t count, std::string_view noun);

  private:
    bool more();
    std::size_t read_line_end();

    std::string name_;
    File_bytes* bytes_ = nullptr;
    bool ended_ = false;          ///< nothing is left in bytes_
    std::string buffer_;          ///< of bytes_, as far as it is read and not yet behind us; rest_ is its end
    std::uint64_t unpacked_ = 0;  ///< bytes that bytes_ gave
    std::uint64_t piece_ = 0;     ///< of these, before the piece began
    char end_ = '\0';             ///< what ends a line, LF or CR; 0 before the first line has told
    std::string_view rest_;
    std::string_view line_;
    std::uint64_t number_ = 0;
    std::vector<std::string_view> fields_;
};

}  // namespace annulus
