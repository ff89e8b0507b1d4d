// SPDX-License-Identifier: GPL-3.0-or-later
// The C++ caller that python/bench/overhead compares Python with: the same moves, from a file, timed one by one.
#include <annulus/moving_mesh.h>

#include <ctime>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>
#include <vector>

namespace {

double processor_seconds() {
    timespec t{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Frames of n points; the first is where the mesh is built. Prints seconds, a line a step.
template <int d>
int follow(const char* file, std::size_t n, const annulus::Options& options) {
    std::ifstream in(file, std::ios::binary);
    std::vector<annulus::Coordinates<d>> x(n);
    const auto next = [&] {
        return static_cast<bool>(
            in.read(reinterpret_cast<char*>(x.data()), static_cast<std::streamsize>(n * sizeof x[0])));
    };
    if (!next()) return 1;
    annulus::Moving_mesh<d> mesh(std::span<const annulus::Coordinates<d>>(x), options);
    while (next()) {
        const double begin = processor_seconds();
        const annulus::Move_result report = mesh.move_all(x);
        const double end = processor_seconds();
        const double seconds = 2 * end - begin - processor_seconds();
        std::printf("%.9f %llu\n", seconds, static_cast<unsigned long long>(report.statistics.flips));
    }
    return 0;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 5) {
        std::fprintf(stderr, "usage: annulus-python-peer FILE DIMENSION POINTS CHANGES\n");
        return 2;
    }
    const std::size_t n = std::strtoull(argv[3], nullptr, 10);
    annulus::Options options;
    options.report_changes = std::string(argv[4]) == "1";
    return std::string(argv[2]) == "2" ? follow<2>(argv[1], n, options) : follow<3>(argv[1], n, options);
}
