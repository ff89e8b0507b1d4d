// SPDX-License-Identifier: GPL-3.0-or-later
// Available and peak memory, from files like those of Linux, and without such files.
#include <apps/report/memory.h>

#include <formats/temporary_directory.h>
#include <support/catch.h>

#include <cstdint>
#include <string>
#include <vector>

namespace annulus {

namespace {

constexpr std::uint64_t kibibyte = 1024;
const char* const meminfo = "MemTotal:       16000000 kB\nMemFree:         1000000 kB\nMemAvailable:    9000000 kB\n";

/// From files of this content; "-" is a file that is not there.
std::uint64_t available(const std::string& of_machine, const std::string& most, const std::string& used) {
    const annulus_test::Temporary_directory directory;
    const auto path = [&](const std::string& name, const std::string& content) {
        return content == "-" ? (directory.path() / name).string() : directory.file(name, content).string();
    };
    return available_memory(path("meminfo", of_machine).c_str(), path("max", most).c_str(),
                            path("current", used).c_str());
}

std::uint64_t peak(const std::string& status) {
    const annulus_test::Temporary_directory directory;
    return peak_resident_memory(directory.file("status", status).string().c_str());
}

}  // namespace

TEST_CASE("Memory at the peak is the line VmHWM of a process, and 0 where there is none", "[memory]") {
    CHECK(peak("Name:\tannulus\nVmPeak:\t  900000 kB\nVmHWM:\t  123456 kB\nVmRSS:\t  100000 kB\n") ==
          123456 * kibibyte);
    CHECK(peak("Name:\tVmHWM:\nVmRSS:\t 7 kB\n") == 0);
    CHECK(peak("VmHWM:\n") == 0);
    CHECK(peak("VmHWM:\tmuch\n") == 0);
    CHECK(peak("") == 0);
    CHECK(peak("VmHWM:\t 4000000000 kB") == 4'000'000'000 * kibibyte);
    CHECK(peak_resident_memory("/no such directory/status") == 0);
    CHECK(peak_resident_memory("/") == 0);
}

TEST_CASE("Memory that is available is what the machine has, and the control group leaves", "[memory]") {
    const std::uint64_t of_machine = 9'000'000 * kibibyte;
    CHECK(available(meminfo, "-", "-") == of_machine);
    CHECK(available(meminfo, "max\n", "5000000\n") == of_machine);
    CHECK(available(meminfo, "", "") == of_machine);
    CHECK(available(meminfo, "3000000\n", "-") == of_machine);
    CHECK(available(meminfo, "3000000\n", "1000000\n") == 2'000'000);
    CHECK(available(meminfo, "90000000000000\n", "1000000\n") == of_machine);
    // No memory is left, which differs from unknown.
    CHECK(available(meminfo, "3000000\n", "3000000\n") == 1);
    CHECK(available(meminfo, "3000000\n", "4000000\n") == 1);
    CHECK(available("-", "-", "-") == 0);
    CHECK(available("MemTotal: 5 kB\n", "max\n", "7\n") == 0);
}

TEST_CASE("the peak of memory grows with what is touched") {
    const std::uint64_t before = peak_resident_memory();
    if (before == 0) return;  // the system does not report it
    std::vector<char> block(64u << 20, 'x');
    CHECK(block[block.size() / 2] == 'x');
    CHECK(peak_resident_memory() >= (60u << 20));
    CHECK(peak_resident_memory() >= before);
    CHECK(before < (std::uint64_t{1} << 40));
}

}  // namespace annulus
