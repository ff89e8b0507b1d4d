// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/progress.h>

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <utility>

namespace annulus::cli {

Progress::Progress(std::string label, std::uint64_t steps, bool quiet)
    : label_(std::move(label)),
      steps_(std::max<std::uint64_t>(steps, 1)),
      visible_(!quiet && isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (visible_) std::fputs("\r\033[K", stderr);
}

void Progress::show(std::uint64_t step, const std::string& news) {
    if (!visible_) return;
    const auto now = Clock::now();
    if (step != steps_ && now - drawn_ < std::chrono::milliseconds(100)) return;
    drawn_ = now;
    constexpr int width = 30;
    const double share = static_cast<double>(step) / static_cast<double>(steps_);
    const int filled = static_cast<int>(share * width);
    const double seconds = std::chrono::duration<double>(now - start_).count();
    std::string bar;
    for (int i = 0; i < width; ++i) bar += i < filled ? "█" : "·";
    std::fprintf(stderr, "\r\033[K%s %s %3.0f %%  %llu/%llu  %.0f steps/s  %s", label_.c_str(), bar.c_str(),
                 100 * share, static_cast<unsigned long long>(step), static_cast<unsigned long long>(steps_),
                 seconds > 0 ? static_cast<double>(step) / seconds : 0.0, news.c_str());
    std::fflush(stderr);
}

}  // namespace annulus::cli
