// SPDX-License-Identifier: GPL-3.0-or-later
// The name of a processor, from /proc/cpuinfo of several architectures.
#include <apps/report/processor.h>

#include <support/catch.h>

#include <sstream>

namespace annulus {

namespace {

std::string name(const std::string& cpuinfo, const std::string& architecture) {
    std::istringstream text(cpuinfo);
    return processor_name(text, architecture);
}

}  // namespace

TEST_CASE("A processor is called what the system calls it") {
    CHECK(name("processor\t: 0\nvendor_id\t: GenuineIntel\nmodel\t\t: 143\nmodel name\t: Intel(R) Xeon(R)  "
               "\nstepping\t: 8\n\n"
               "processor\t: 1\nmodel name\t: another\n",
               "x86_64") == "Intel(R) Xeon(R)");
    CHECK(name("processor\t: 0\ncpu\t\t: POWER9, altivec supported\nclock\t\t: 2166.000000MHz\n", "ppc64le") ==
          "POWER9, altivec supported");
    CHECK(name("processor\t: 0\nhart\t\t: 2\nisa\t\t: rv64imafdc\nuarch\t\t: sifive,u74-mc\n", "riscv64") ==
          "sifive,u74-mc");
}

TEST_CASE(
    "A processor without a name is called by its architecture, and on arm64 by the numbers of its maker and design") {
    const std::string arm =
        "processor\t: 0\nBogoMIPS\t: 243.75\nFeatures\t: fp asimd\nCPU implementer\t: 0x41\nCPU architecture: 8\n"
        "CPU variant\t: 0x3\nCPU part\t: 0xd0c\nCPU revision\t: 1\n";
    CHECK(name(arm, "aarch64") == "aarch64 processor (implementer 0x41, part 0xd0c)");
    CHECK(name("", "aarch64") == "aarch64 processor");
    CHECK(name("model name\t:\nno colon\n", "x86_64") == "x86_64 processor");
    CHECK(name("", "") == "unknown processor");
    CHECK_FALSE(processor_name().empty());
}

}  // namespace annulus
