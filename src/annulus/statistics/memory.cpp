// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/statistics/memory.h>

#include <cstdio>

namespace annulus {

Resident_memory resident_memory() noexcept {
    Resident_memory memory;
    std::FILE* const status = std::fopen("/proc/self/status", "r");
    if (status == nullptr) return memory;
    char line[256];
    unsigned long long kibibytes = 0;
    while (std::fgets(line, sizeof line, status) != nullptr) {
        if (std::sscanf(line, "VmHWM: %llu kB", &kibibytes) == 1) memory.peak = kibibytes * 1024;
        if (std::sscanf(line, "VmRSS: %llu kB", &kibibytes) == 1) memory.current = kibibytes * 1024;
    }
    std::fclose(status);
    return memory;
}

}  // namespace annulus
