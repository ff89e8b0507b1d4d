// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/progress.h>

#include <unistd.h>

#include <cstdio>
#include <utility>

namespace annulus::cli {

Progress::Progress(std::string label, std::uint64_t steps, bool quiet)
    : label_(std::move(label)),
      steps_(steps),
      visible_(!quiet && isatty(STDERR_FILENO) == 1) {}

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
    std::string bar;
    if (share) {
        constexpr int width = 30;
        const int filled = static_cast<int>(*share * width);
        for (int i = 0; i < width; ++i) bar += i < filled ? "█" : "·";
        char percent[16];
        std::snprintf(percent, sizeof percent, " %3.0f %%  ", 100 * *share);
        bar += percent;
    }
    const std::string of = steps_ > 0 ? "/" + std::to_string(steps_) : " steps";
    std::fprintf(stderr, "\r\033[K%s %s%llu%s  %.0f steps/s  %s", label_.c_str(), bar.c_str(),
                 static_cast<unsigned long long>(step), of.c_str(),
                 seconds > 0 ? static_cast<double>(step) / seconds : 0.0, news.c_str());
    std::fflush(stderr);
}

}  // namespace annulus::cli
