// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/progress.h>

#include <apps/formats/formatted.h>
#include <apps/formats/input_error.h>

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

/// A dumb terminal cannot clear a line, nor may one of no kind.
bool draws_here() {
    const char* const word = std::getenv("TERM");
    const std::string_view terminal = word == nullptr ? "" : word;
    return isatty(STDERR_FILENO) == 1 && !terminal.empty() && terminal != "dumb";
}

/// The width that the terminal reports; if unknown, that of the environment, or 80.
std::size_t columns_of_terminal() {
    winsize size{};
    if (ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) return size.ws_col;
    if (const char* const word = std::getenv("COLUMNS")) {
        const std::string_view text(word);
        std::size_t columns = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), columns);
        if (error == std::errc() && end == text.data() + text.size() && columns > 0) return columns;
    }
    return 80;
}

std::string bar(double share, std::size_t width) {
    const auto filled = static_cast<std::size_t>(std::clamp(share, 0.0, 1.0) * static_cast<double>(width));
    return std::string(filled, '#') + std::string(width - filled, '.') + " ";
}

}  // namespace

std::string Progress_line::in(std::size_t columns) const {
    constexpr std::size_t longest = 30, shortest = 5;
    std::string line = label + " ", rest = steps;
    if (share) rest = formatted("%3.0f %%  ", 100 * std::clamp(*share, 0.0, 1.0)) + rest;
    for (const std::string& part : {rate, news}) {
        if (line.size() + rest.size() + 2 + part.size() > columns) break;
        if (!part.empty()) rest += "  " + part;
    }
    const std::size_t taken = line.size() + rest.size() + 1;
    if (share && columns >= taken + shortest) line += bar(*share, std::min(longest, columns - taken));
    line += rest;
    if (line.size() > columns) line.resize(columns);
    for (char& c : line)
        if (c < ' ' || c > '~') c = '?';
    return line;
}

Progress::Progress(std::string label, std::uint64_t steps, bool quiet)
    : label_(std::move(label)), steps_(steps), visible_(!quiet && draws_here()) {}

Progress::~Progress() {
    if (visible_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::uint64_t step, const std::string& news, std::optional<double> share) {
    if (!visible_) return;
    const auto now = Clock::now();
    if (step != steps_ && now - drawn_ < std::chrono::milliseconds(100)) return;
    drawn_ = now;
    if (!share && steps_ > 0) share = static_cast<double>(step) / static_cast<double>(steps_);
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const std::string rate = formatted("%.0f steps/s", seconds > 0 ? static_cast<double>(step) / seconds : 0.0);
    const Progress_line line{label_,
                             steps_ > 0 ? std::to_string(step) + "/" + std::to_string(steps_) : counted(step, "step"),
                             rate, news, share};
    // The last column stays empty: a terminal may wrap after it.
    std::fprintf(stderr, "\r\033[K%s", line.in(columns_of_terminal() - 1).c_str());
    std::fflush(stderr);
}

}  // namespace annulus::inline v1::cli
