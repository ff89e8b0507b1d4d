// SPDX-License-Identifier: GPL-3.0-or-later
#include "peak_memory.h"

#include <malloc.h>
#include <sys/wait.h>
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

double grown(Make_contestant make, const Points<3>& x) {
    const std::size_t few = 64;
    Points<3> some;
    for (std::size_t i = 0; i < x.size(); i += x.size() / few + 1) some.push_back(x[i]);
    make()->rebuild(some);
    (void)malloc_trim(0);
    // Writing 5 makes the peak what is resident now.
    std::ofstream("/proc/self/clear_refs") << "5" << std::flush;
    const double before = memory("VmHWM");
    const auto contestant = make();
    contestant->rebuild(x);
    return memory("VmHWM") - before;
}

}  // namespace

double peak_memory(Make_contestant make, const Points<3>& x) {
    double bytes = std::numeric_limits<double>::quiet_NaN();
    int ends[2];
    if (pipe(ends) != 0) return bytes;
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0) {
        try {
            const double b = grown(make, x);
            (void)!write(ends[1], &b, sizeof b);
        } catch (const std::exception& e) {
            std::fprintf(stderr, "annulus-peers: %s\n", e.what());
        }
        _exit(0);
    }
    (void)close(ends[1]);
    double measured = 0.0;
    if (child > 0) {
        if (read(ends[0], &measured, sizeof measured) == sizeof measured) bytes = measured;
        (void)waitpid(child, nullptr, 0);
    }
    (void)close(ends[0]);
    return bytes;
}

}  // namespace bench
