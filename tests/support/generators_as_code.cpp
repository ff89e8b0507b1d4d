// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators.h"

#include <cstdio>

namespace annulus::testing {

std::string as_code(double x) {
    std::array<char, 40> text;
    std::snprintf(text.data(), text.size(), "%a", x);
    return text.data();
}

std::string as_code(const Point& p) { return "{" + as_code(p[0]) + ", " + as_code(p[1]) + "}"; }

std::string as_code(const Points& points) {
    std::string text = "const std::vector<annulus::Coordinates<2>> points{";
    for (const Point& p : points) text += "\n    " + as_code(p) + ",";
    return text + "};";
}

std::string as_code(const Bicell& c) {
    return "const annulus::testing::Bicell x{" + as_code(c.a) + ", " + as_code(c.b) + ", " + as_code(c.p) + ", " +
           as_code(c.q) + "};";
}

std::string as_code(const Triangle& t) {
    return "const annulus::testing::Triangle x{" + as_code(t.a) + ", " + as_code(t.b) + ", " + as_code(t.c) + "};";
}

}  // namespace annulus::testing
