// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

namespace annulus::cli {

/// A bar on standard error with steps per second and a word of news, drawn at most ten times a second. Only on a
/// terminal that is not dumb, and never wider than it is at that moment.
class Progress {
  public:
    /// `steps` is 0 where the number of steps is unknown.
    Progress(std::string label, std::uint64_t steps, bool quiet);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// The bar is `share` long where that is given, else as many of the steps as are done.
    void show(std::uint64_t step, const std::string& news, std::optional<double> share = std::nullopt);

  private:
    using Clock = std::chrono::steady_clock;
    std::string label_;
    std::uint64_t steps_;
    bool visible_;
    Clock::time_point start_ = Clock::now();
    Clock::time_point drawn_{};
};

/// What a progress line says, of which `columns` columns are shown: all of it with a bar, as long as there is room,
/// without one, or the beginning. Every byte is one printable character of one column, whatever the words were.
struct Progress_line {
    std::string label, steps, rate, news;
    std::optional<double> share;
    [[nodiscard]] std::string in(std::size_t columns) const;
};

}  // namespace annulus::cli
