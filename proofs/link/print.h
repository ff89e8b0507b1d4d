// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/predicate/certificate_value.h>

#include <cmath>
#include <cstdio>
#include <vector>

namespace annulus::link {

/// One line of output, a Coq term: a constructor with its arguments. Numbers are hexadecimal, so nothing is rounded.
class Row {
  public:
    explicit Row(const char* constructor) { std::printf("%s", constructor); }
    ~Row() { std::printf("\n"); }
    Row(const Row&) = delete;
    Row& operator=(const Row&) = delete;

    void number(double x) {
        if (std::isnan(x)) std::printf(" nan");
        else if (std::isinf(x)) std::printf(x > 0.0 ? " infinity" : " neg_infinity");
        else if (std::signbit(x)) std::printf(" (%a)", x);
        else std::printf(" %a", x);
    }
    void numbers(const std::vector<double>& xs) {
        for (const double x : xs) number(x);
    }
    template <class Point, std::size_t k>
    void points(const std::array<Point, k>& x) {
        for (const Point& p : x)
            for (const double c : p) number(c);
    }
    void truth(bool b) { std::printf(b ? " true" : " false"); }
    void text(const char* w) { std::printf(" \"%s\"%%string", w); }
    void answer(bool answered, const Certificate_value& v) {
        if (!answered) {
            std::printf(" refused");
            return;
        }
        std::printf(v.sign > 0 ? " (positive" : v.sign < 0 ? " (negative" : " (zero");
        number(v.tolerance);
        std::printf(")");
    }
};

}  // namespace annulus::link
