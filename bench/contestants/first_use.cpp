// SPDX-License-Identifier: GPL-3.0-or-later
#include "first_use.h"

#include <malloc.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <cstdio>
#include <exception>
#include <fstream>
#include <limits>
#include <string>

namespace bench {

namespace {

/// A line of /proc/self/status, in bytes; NaN where there is none.
double memory(const std::string& name) {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.rfind(name + ":", 0) == 0) return 1024.0 * std::stod(line.substr(name.size() + 1));
    return std::numeric_limits<double>::quiet_NaN();
}

template <int d>
First_use measured(Make_contestant<d> make, const Points<d>& x) {
    const std::size_t few = 64;
    Points<d> some;
    for (std::size_t i = 0; i < x.size(); i += x.size() / few + 1) some.push_back(x[i]);
    make()->rebuild(some);
    (void)malloc_trim(0);
    // Writing 5 makes the peak what is resident now.
    std::ofstream("/proc/self/clear_refs") << "5" << std::flush;
    const double before = memory("VmHWM");
    const double begin = processor_seconds();
    const auto contestant = make();
    contestant->rebuild(x);
    const double seconds = processor_seconds() - begin;
    return {memory("VmHWM") - before, seconds};
}

}  // namespace

double processor_seconds() {
    timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

template <int d>
First_use first_use(Make_contestant<d> make, const Points<d>& x) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    First_use result{nan, nan};
    int ends[2];
    if (pipe(ends) != 0) return result;
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        try {
            const First_use now = measured<d>(make, x);
            (void)!write(ends[1], &now, sizeof now);
        } catch (const std::exception& e) {
            std::fprintf(stderr, "annulus-peers: %s\n", e.what());
        }
        _exit(0);
    }
    (void)close(ends[1]);
    First_use now{};
    if (child > 0) {
        if (read(ends[0], &now, sizeof now) == sizeof now) result = now;
        (void)waitpid(child, nullptr, 0);
    }
    (void)close(ends[0]);
    return result;
}

template First_use first_use<2>(Make_contestant<2>, const Points<2>&);
template First_use first_use<3>(Make_contestant<3>, const Points<3>&);

}  // namespace bench
