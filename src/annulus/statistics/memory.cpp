// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/statistics/memory.h>

#include <algorithm>
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

/// The number that a file is, else 0.
std::uint64_t read_number(const char* file) noexcept {
    std::FILE* from = std::fopen(file, "re");
    if (from == nullptr) return 0;
    unsigned long long number = 0;
    if (std::fscanf(from, "%llu", &number) != 1) number = 0;
    std::fclose(from);
    return number;
}

}  // namespace

std::uint64_t peak_resident_memory() noexcept { return read_entry("/proc/self/status", "VmHWM:"); }

std::uint64_t available_memory() noexcept {
    const std::uint64_t of_machine = read_entry("/proc/meminfo", "MemAvailable:");
    const std::uint64_t most = read_number("/sys/fs/cgroup/memory.max");
    const std::uint64_t used = read_number("/sys/fs/cgroup/memory.current");
    if (most == 0 || used == 0) return of_machine;  // no limit (the word `max`), or none that is told
    return std::min(of_machine, most > used ? most - used : 1);  // 0 would mean that nothing is known
}

}  // namespace annulus
