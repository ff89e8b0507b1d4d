// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/statistics/memory.h>

#include <cstdio>

namespace annulus {

std::uint64_t peak_resident_memory() noexcept {
    std::FILE* const status = std::fopen("/proc/self/status", "r");
    if (status == nullptr) return 0;
    char line[256];
    unsigned long long kibibytes = 0;
    while (std::fgets(line, sizeof line, status) != nullptr && std::sscanf(line, "VmHWM: %llu kB", &kibibytes) != 1)
        continue;
    std::fclose(status);
    return kibibytes * 1024;
}

}  // namespace annulus
