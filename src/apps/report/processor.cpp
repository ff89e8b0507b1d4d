// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/processor.h>

#include <sys/utsname.h>

#include <fstream>
#include <map>

namespace annulus::inline v1 {

namespace {

std::string trimmed(const std::string& s) {
    const char* const blank = " \t\r";
    const std::size_t first = s.find_first_not_of(blank);
    return first == std::string::npos ? "" : s.substr(first, s.find_last_not_of(blank) - first + 1);
}

/// The first non-empty value of each key of the text `key : value`.
std::map<std::string, std::string> entries_of(std::istream& text) {
    std::map<std::string, std::string> entries;
    for (std::string line; std::getline(text, line);) {
        const std::size_t colon = line.find(':');
        if (colon == std::string::npos) continue;
        const std::string value = trimmed(line.substr(colon + 1));
        if (!value.empty()) entries.emplace(trimmed(line.substr(0, colon)), value);
    }
    return entries;
}

}  // namespace

std::string processor_name(std::istream& cpuinfo, const std::string& architecture) {
    const auto entries = entries_of(cpuinfo);
    // x86 and LoongArch, LoongArch before 6.9, MIPS, POWER, RISC-V.
    for (const char* key : {"model name", "Model Name", "cpu model", "cpu", "uarch"})
        if (const auto found = entries.find(key); found != entries.end()) return found->second;
    const std::string unnamed = architecture.empty() ? "unknown processor" : architecture + " processor";
    const auto maker = entries.find("CPU implementer"), design = entries.find("CPU part");
    if (maker == entries.end() || design == entries.end()) return unnamed;
    return unnamed + " (implementer " + maker->second + ", part " + design->second + ")";
}

std::string processor_name() {
    std::ifstream cpuinfo("/proc/cpuinfo");
    utsname system{};
    return processor_name(cpuinfo, ::uname(&system) == 0 ? system.machine : "");
}

}  // namespace annulus::inline v1
