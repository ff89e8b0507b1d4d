// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/statistics/memory.h>

#include <cstdio>
#include <string_view>

namespace annulus {

namespace {

/// The number of kibibytes after `name` at the beginning of a line, in bytes.
std::uint64_t read_entry(const char* file, std::string_view name) noexcept {
    std::FILE* const lines = std::fopen(file, "r");
    if (lines == nullptr) return 0;
    char line[256];
    unsigned long long kibibytes = 0;
    while (std::fgets(line, sizeof line, lines) != nullptr)
        if (std::string_view(line).starts_with(name) && std::sscanf(line + name.size(), "%llu", &kibibytes) == 1) break;
    std::fclose(lines);
    return kibibytes * 1024;
}

}  // namespace

std::uint64_t peak_resident_memory() noexcept { return read_entry("/proc/self/status", "VmHWM:"); }
std::uint64_t available_memory() noexcept { return read_entry("/proc/meminfo", "MemAvailable:"); }

}  // namespace annulus
