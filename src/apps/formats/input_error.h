// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>

#include <cstdint>
#include <string>
#include <string_view>

namespace annulus::inline v1 {

/// The error of a file that cannot be read or has invalid content.
///
/// `what()` is one line, `FILE:LINE: fault; expected EXPECTED`. Faults of the file as a whole (missing, a directory,
/// of unknown format) have line 0 and read `FILE: fault; expected EXPECTED`.
class Input_error : public Error {
  public:
    Input_error(Error_code code, std::string file, std::uint64_t line, std::string fault, std::string expected);

    [[nodiscard]] const std::string& file() const noexcept { return file_; }
    /// Counted from 1; 0 when the fault is of the whole file; the number of the record in binary files.
    [[nodiscard]] std::uint64_t line() const noexcept { return line_; }
    [[nodiscard]] const std::string& fault() const noexcept { return fault_; }
    [[nodiscard]] const std::string& expected() const noexcept { return expected_; }

  private:
    std::string file_;
    std::uint64_t line_;
    std::string fault_;
    std::string expected_;
};

/// A piece of a file as it may be shown on a terminal: in quotes, at most 40 bytes, bytes that are not printable ASCII
/// as `\xNN`, so that a binary file can neither break the line nor drive the terminal.
[[nodiscard]] std::string shown(std::string_view text);

/// "1 column", "2 columns".
[[nodiscard]] std::string counted(std::uint64_t count, std::string_view noun);

}  // namespace annulus::inline v1
