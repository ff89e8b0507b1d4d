// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/formatted.h>

#include <support/catch.h>

#include <string>

using namespace annulus;

TEST_CASE("Formatted text is what printf writes, of any length") {
    CHECK(formatted("%.2f %% within %s", 12.345, "tolerance") == "12.35 % within tolerance");
    CHECK(formatted("%08lx ", 0xbeefUL) == "0000beef ");
    CHECK(formatted("%a", 1.5) == "0x1.8p+0");
    CHECK(formatted("%s", "").empty());
    const std::string text(3000, 'x');
    CHECK(formatted("<%s>", text.c_str()) == "<" + text + ">");
    CHECK(formatted("%.0f", 0x1p1023).size() == 308);
}
