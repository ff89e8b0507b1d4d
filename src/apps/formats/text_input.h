// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/input_error.h>
#include <apps/formats/parse_double.h>

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

class File_bytes;

/// A file in memory and its name for messages. `content` has no leading UTF-8 byte order mark.
struct Source {
    std::string name;
    std::string content;
};

/// The most that a reader holds of a pipe, and a bound for pictures: all allowed pixels fit.
inline constexpr std::uint64_t most_of_a_pipe = std::uint64_t{1} << 30;

/// The number of bytes that load_file with `most` reads: most_of_a_pipe at most of what is not a regular file, which
/// may have no end.
[[nodiscard]] std::uint64_t bound_of(const File_bytes& bytes, std::uint64_t most);

/// Reads a whole file, unpacked where it is packed. Throws Input_error when it is missing, a directory, unreadable or
/// empty, when its packed content is damaged, cut off, or more than 64 MiB and a hundred times the file, and when it
/// has more than bound_of(file, most) bytes.
[[nodiscard]] Source load_file(const std::filesystem::path& file,
                               std::uint64_t most = std::numeric_limits<std::uint64_t>::max());
[[nodiscard]] Source load_file(File_bytes& bytes, std::uint64_t most = std::numeric_limits<std::uint64_t>::max());

/// Fails where a packed file has grown beyond 64 MiB and a hundred times what was read of it: a text of coordinates
/// packs to a third or a tenth, and content that expands without end is not text. `line` is that of the fault.
void require_no_bomb(const File_bytes& bytes, std::uint64_t unpacked, std::uint64_t line);

/// The words of a line between blanks.
void split_at_blanks(std::string_view line, std::vector<std::string_view>& words);

/// Walks over the lines of a text and splits them into fields. LF and CRLF both end a line; CR alone, as old programs
/// write it, in a text whose first line ends so. A text that ends some lines by CR and others by LF is a fault.
///
/// The text is in memory, or a file that is read line by line: then only the line and a block are held, an error of
/// File_bytes is a fault of the next line, and a line of more than 64 MiB is a fault. Every fault is reported by `fail`
/// with the number of the current line; past the end it stays on the last line. The text must outlive the reader.
class Line_reader {
  public:
    explicit Line_reader(const Source& source) : name_(source.name), rest_(source.content) {}
    /// Nothing is read before the first line is requested. Text in UTF-16 is read as text in UTF-8. A leading byte
    /// order mark is skipped, an empty file is a fault.
    explicit Line_reader(File_bytes& bytes);
    Line_reader(const Line_reader&) = delete;  // views of its own text
    Line_reader& operator=(const Line_reader&) = delete;

    /// The caller keeps what is read from here on until the next call: if the file is packed, this is bounded by 64 MiB
    /// and a hundred times the file.
    void begin_piece() noexcept { piece_ = unpacked_; }

    /// Advances to the next line; false at the end of the file, where the fields are empty.
    bool next_line();

    /// Advances to the next line that is neither blank nor a comment and splits it at white space; # starts a comment.
    bool next_record();

    /// The current line without its end.
    [[nodiscard]] std::string_view line() const noexcept { return line_; }
    /// Number of the current line, from 1; 0 before the first.
    [[nodiscard]] std::uint64_t number() const noexcept { return number_; }
    [[nodiscard]] const std::vector<std::string_view>& fields() const noexcept { return fields_; }
    /// The rest of a text in memory after the current line.
    [[nodiscard]] std::string_view rest() const noexcept { return rest_; }

    [[nodiscard]] const std::string& name() const noexcept { return name_; }

    [[noreturn]] void fail(std::string fault, std::string expected, Error_code code = Error_code::bad_input) const;
    /// The same for an earlier line.
    [[noreturn]] void fail_at(std::uint64_t line, std::string fault, std::string expected,
                              Error_code code = Error_code::bad_input) const;

    /// `text` as a finite double; `what` names it in the fault ("x").
    [[nodiscard]] double real(std::string_view text, std::string_view what) const;

    /// `text` as an integer of 0 or more that fits in 64 bits.
    [[nodiscard]] std::uint64_t whole(std::string_view text, std::string_view what) const;

    /// The number of records, `count` at most, for which to reserve memory: no more than the rest of the file, as far
    /// as it is in memory, can hold at `bytes` bytes each (end of line included), so that a wrong count never
    /// determines an allocation. Fails when there are more than an Index can number.
    [[nodiscard]] std::size_t room_for(std::uint64_t count, std::uint64_t bytes, std::string_view noun) const;

    /// Advances to the next record, the one after `done` of `count`; fails when the file ends first.
    void require_record(std::uint64_t done, std::uint64_t count, std::string_view noun);

  private:
    bool more();
    std::size_t read_line_end();

    std::string name_;
    File_bytes* bytes_ = nullptr;
    bool ended_ = false;          ///< nothing is left in bytes_
    std::string buffer_;          ///< bytes read and not yet passed; rest_ is its end
    std::uint64_t unpacked_ = 0;  ///< bytes that bytes_ returned
    std::uint64_t piece_ = 0;     ///< of these, before the piece began
    char end_ = '\0';             ///< the end of a line, LF or CR; 0 before the first line
    std::string_view rest_;
    std::string_view line_;
    std::uint64_t number_ = 0;
    std::vector<std::string_view> fields_;
};

}  // namespace annulus::inline v1
