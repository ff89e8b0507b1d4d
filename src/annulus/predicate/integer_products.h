// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/wide_integer.h>

#include <array>
#include <cstddef>
#include <cstdint>

// What determinants of integers are made of (integer_signs.cpp): by growing integers, or where everything fits into one
// type.
namespace annulus::inline v1::fixed_width {

template <class Integer>
[[nodiscard]] int sign_of(Integer x) {
    return x > 0 ? 1 : x < 0 ? -1 : 0;
}
template <std::size_t N>
[[nodiscard]] int sign_of(const Wide_integer<N>& x) {
    return x.sign();
}

/// Products and sums of products of integers that grow: with w words for a coordinate, 2 w for a minor and a square,
/// 3 w for a determinant of three vectors, and 4 w and 5 w for the determinants of spheres.
struct Growing_words {
    static Wide_integer<2> minor(std::int64_t a, std::int64_t b, std::int64_t c, std::int64_t e) {
        return wide(Int128{a} * e - Int128{b} * c);
    }
    static Wide_integer<4> minor(Int128 a, Int128 b, Int128 c, Int128 e) {
        return product(wide(a), wide(e)) - product(wide(b), wide(c));
    }
    template <std::size_t d>
    static Wide_integer<2> square(const std::array<std::int64_t, d>& a) {
        Int128 s = 0;
        for (const std::int64_t c : a) s += Int128{c} * c;
        return wide(s);
    }
    template <std::size_t d>
    static Wide_integer<4> square(const std::array<Int128, d>& a) {
        Wide_integer<4> s;
        for (const Int128 c : a) s = s + product(wide(c), wide(c));
        return s;
    }
    template <class Minor, class Integer>
    static auto dot(const std::array<Minor, 3>& n, const std::array<Integer, 3>& a) {
        return product(n[0], wide(a[0])) + product(n[1], wide(a[1])) + product(n[2], wide(a[2]));
    }
    template <class A, class B>
    static auto times(const A& a, const B& b) {
        return product(a, b);
    }
};

/// The same where everything fits into one type.
template <class Result>
struct Fitting {
    template <class Integer>
    static Result minor(Integer a, Integer b, Integer c, Integer e) {
        return Result{a} * e - Result{b} * c;
    }
    template <class Integer, std::size_t d>
    static Result square(const std::array<Integer, d>& a) {
        Result s = 0;
        for (const Integer c : a) s += Result{c} * c;
        return s;
    }
    template <class Integer>
    static Result dot(const std::array<Result, 3>& n, const std::array<Integer, 3>& a) {
        return n[0] * a[0] + n[1] * a[1] + n[2] * a[2];
    }
    static Result times(Result a, Result b) { return a * b; }
};

/// The cross product of two vectors, by either.
template <class By, class Integer>
auto cross(const std::array<Integer, 3>& a, const std::array<Integer, 3>& b) {
    return std::array{By::minor(a[1], a[2], b[1], b[2]), By::minor(a[2], a[0], b[2], b[0]),
                      By::minor(a[0], a[1], b[0], b[1])};
}

}  // namespace annulus::inline v1::fixed_width
