// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// Entries that survive the process, however it ends: an append-only file; each line is a CRC-32 and a text. A last
/// line that was cut off by a kill is recognised and dropped when the journal is opened again; so is a damaged line. An
/// appended line is on the disk after a second at most.
class Journal {
  public:
    /// Opens or makes the file, and locks it. `head` identifies the sweep. Throws Error(bad_input) where another
    /// process has it open, or, unless it is to `begin_anew`, where it has another head or is not a journal;
    /// std::system_error for failures of the system.
    Journal(std::filesystem::path file, const std::string& head, bool begin_anew);
    ~Journal();
    Journal(const Journal&) = delete;
    Journal& operator=(const Journal&) = delete;

    [[nodiscard]] std::size_t size() const { return place_.size(); }
    /// Entry i, in the order of writing. Throws Error(bad_input) if the file has been changed meanwhile.
    [[nodiscard]] std::string entry(std::size_t i) const;
    /// Appends one line, given without line ends.
    void append(std::string_view text);

  private:
    struct Place {
        std::uint64_t begin;
        std::uint64_t size;
    };
    void open_and_lock();
    void read(const std::string& head);
    void require_head(std::string_view line, const std::string& head, bool ended) const;
    void write(std::string_view line);
    [[noreturn]] void fail(const char* what) const;

    std::filesystem::path file_;
    int descriptor_ = -1;
    std::uint64_t end_ = 0;
    std::vector<Place> place_;  // of texts
    std::chrono::steady_clock::time_point synchronised_ = std::chrono::steady_clock::now();
};

}  // namespace annulus::inline v1
