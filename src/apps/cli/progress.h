// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace annulus::inline v1::cli {

/// A progress bar on standard error with steps per second and short news, drawn at most ten times a second. It is shown
/// only on a terminal that has a kind (TERM) and is not dumb, and is never wider than the terminal.
class Progress {
  public:
    /// `steps` is 0 if the number of steps is unknown.
    Progress(std::string label, std::uint64_t steps, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// The length of the bar is `share` if that is given, otherwise the fraction of the steps that are done.
    void show(std::uint64_t step, const std::string& news, std::optional<double> share = std::nullopt);

  private:
    using Clock = std::chrono::steady_clock;
    std::string label_;
    std::uint64_t steps_;
    bool visible_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point drawn_{};
};

/// The text of a progress line. `in(columns)` fits it into that many columns: all of it if there is room, otherwise
/// without the news, or without the rate and the news, or else its beginning; with a bar where room is left for one.
/// Every byte of the result is one printable character of one column.
struct Progress_line {
    std::string label, steps, rate, news;
    std::optional<double> share;
    [[nodiscard]] std::string in(std::size_t columns) const;
};

}  // namespace annulus::inline v1::cli
