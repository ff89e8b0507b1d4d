// SPDX-License-Identifier: GPL-3.0-or-later
// Files that gzip has packed.
#include "gzip.h"
#include "point_cases.h"

#include <apps/formats/read_points.h>

#include <support/catch.h>

#include <vector>

using namespace annulus;
using namespace annulus_test;

TEST_CASE("what gzip packed is read in every format, damaged or cut off it is refused") {
    const Temporary_directory directory;
    const auto read = [](const auto& file) { (void)read_points<2>(file); };
    CHECK(accept<2>("A.XYZ.GZ", gzip("1 2\n") + gzip("3 4\n")).points == Points_2{{1, 2}, {3, 4}});
    CHECK(accept<2>("a.csv.gz", gzip("\xef\xbb\xbfx,y\n1,2\n")).points == Points_2{{1, 2}});
    CHECK(accept<3>("a.off.gz", gzip("OFF\n1 0 0\n1 2 3\n")).points == Points_3{{1, 2, 3}});
    const std::string long_text = [] {
        std::string text;
        for (int i = 0; i < 40'000; ++i) text += std::to_string(i) + " " + std::to_string(i * 7919 % 40'000) + "\n";
        return text;
    }();
    const auto many = accept<2>("a.xyz.gz", gzip(long_text.substr(0, 100'000)) + gzip(long_text.substr(100'000)));
    REQUIRE(many.points.size() == 40'000);
    CHECK(many.points.back() == Coordinates<2>{39'999, 39'999 * 7919 % 40'000});
    // Packed content has lines, too: a fault is reported at the first incomplete one.
    const std::string packed = gzip(long_text);
    try {
        read(directory.file("a.xyz.gz", packed.substr(0, packed.size() / 2)));
        FAIL("was accepted");
    } catch (const Input_error& error) {
        CHECK(error.fault() == "is cut off");
        CHECK(error.line() > 10'000u);
        CHECK(error.line() < 30'000u);
    }
    expect_fault(directory.file("a.xyz.gz", packed.substr(0, packed.size() - 1)), 40'001, "is cut off", read);
    expect_fault(directory.file("a.xyz.gz", packed.substr(0, 1)), 1, "is cut off", read);
    expect_fault(directory.file("a.xyz.gz", packed + "and more"), 40'001, "damaged", read);
    expect_fault(directory.file("a.off.gz", packed.substr(0, packed.size() / 2)), 0, "is cut off", read);
    expect_fault(directory.file("a.xyz.gz", "1 2\n"), 1, "no gzip file", read);
    expect_fault(directory.file("a.xyz.gz", ""), 1, "is empty", read);
    expect_fault(directory.file("a.xyz.gz", gzip("")), 1, "is empty", read);
    expect_fault(directory.file("a.gz", gzip("1 2\n")), 0, "has no extension", read);
    expect_fault(directory.file("a.pp.gz", gzip("1 2\n")), 0, "unknown extension '.pp'", read);
}

TEST_CASE("a small file that unpacks without end is refused before it fills the memory", "[deep]") {
    std::string bomb;
    const std::string member = gzip(std::string(1 << 20, '\n'));
    for (int i = 0; i < 100; ++i) bomb += member;
    bomb.back() ^= 1;  // not checked
    refuse<2>("a.off.gz", bomb, 0, "more than 100 times its size");
    const Temporary_directory directory;
    try {
        (void)read_points<2>(directory.file("a.xyz.gz", bomb));
        FAIL("was accepted");
    } catch (const Input_error& error) {
        CHECK(error.fault() == "grows to more than 100 times its size");
        CHECK(error.line() > std::uint64_t{64} << 20);  // these lines are empty
    }
}
