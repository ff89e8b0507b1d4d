// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/memory.h>

#include <algorithm>
#include <cstdio>
#include <string_view>

namespace annulus::inline v1 {

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

/// The number that a file contains, else 0.
std::uint64_t read_number(const char* file) noexcept {
    std::FILE* from = std::fopen(file, "re");
    if (from == nullptr) return 0;
    unsigned long long number = 0;
    if (std::fscanf(from, "%llu", &number) != 1) number = 0;
    std::fclose(from);
    return number;
}

}  // namespace

std::uint64_t peak_resident_memory() noexcept { return peak_resident_memory("/proc/self/status"); }

std::uint64_t peak_resident_memory(const char* status) noexcept { return read_entry(status, "VmHWM:"); }

std::uint64_t available_memory() noexcept {
    return available_memory("/proc/meminfo", "/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory.current");
}

std::uint64_t available_memory(const char* meminfo, const char* most, const char* used) noexcept {
    const std::uint64_t of_machine = read_entry(meminfo, "MemAvailable:");
    const std::uint64_t limit = read_number(most);
    const std::uint64_t taken = read_number(used);
    if (limit == 0 || taken == 0) return of_machine;               // no limit (the word `max`), or an unknown one
    const std::uint64_t left = limit > taken ? limit - taken : 1;  // 0 would mean that nothing is known
    return std::min(of_machine, left);
}

}  // namespace annulus::inline v1
