// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The generators of generators.h as RapidCheck arguments. A case carries the seed it came from and prints itself as
// C++ code, because RapidCheck's own reproduce strings do not work through Catch. Nothing shrinks here, because a smaller
// seed is no simpler case; programs of calls shrink by themselves (fuzz/common/shrink.h).

#include <support/generators.h>

#include <rapidcheck.h>

#include <cstdint>
#include <ostream>

namespace annulus::testing {

/// The start of a std::mt19937_64, for properties that draw many cases from it.
struct Seed {
    std::uint64_t value;
    [[nodiscard]] Random random() const { return Random(value); }
};

struct Bicell_case {
    Bicell_family family;
    std::uint64_t seed;
    Bicell cell;
};

struct Triangle_case {
    Triangle_family family;
    std::uint64_t seed;
    Triangle triangle;
};

struct Point_set_case {
    Family family;
    std::uint64_t seed;
    Points points;
};

inline void showValue(const Seed& s, std::ostream& out) { out << "seed " << s.value; }
inline void showValue(const Bicell_case& c, std::ostream& out) {
    out << name_of(c.family) << ", seed " << c.seed << "\n" << as_code(c.cell);
}
inline void showValue(const Triangle_case& c, std::ostream& out) {
    out << name_of(c.family) << ", seed " << c.seed << "\n" << as_code(c.triangle);
}
inline void showValue(const Point_set_case& c, std::ostream& out) {
    out << name_of(c.family) << ", seed " << c.seed << ", " << c.points.size() << " points\n" << as_code(c.points);
}

/// 64 random bits, whatever RapidCheck's size parameter is.
inline rc::Gen<std::uint64_t> seeds() {
    return rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
}

inline rc::Gen<Bicell_case> bicell_case(Bicell_family family) {
    return rc::gen::map(seeds(), [family](std::uint64_t seed) {
        Random random(seed);
        return Bicell_case{family, seed, bicell(family, random)};
    });
}

inline rc::Gen<Triangle_case> triangle_case(Triangle_family family) {
    return rc::gen::map(seeds(), [family](std::uint64_t seed) {
        Random random(seed);
        return Triangle_case{family, seed, triangle(family, random)};
    });
}

/// Between `least` and `most` points of the family.
inline rc::Gen<Point_set_case> point_set_case(Family family, int least, int most, bool duplicates = false) {
    return rc::gen::map(seeds(), [=](std::uint64_t seed) {
        Random random(seed);
        const auto n = static_cast<std::size_t>(integer(random, least, most));
        return Point_set_case{family, seed, point_set(family, n, random, duplicates)};
    });
}

/// Any of the families.
inline rc::Gen<Point_set_case> point_set_case(int least, int most, bool duplicates = false) {
    return rc::gen::map(seeds(), [=](std::uint64_t seed) {
        Random random(seed);
        const Family family = all_families[random() % all_families.size()];
        const auto n = static_cast<std::size_t>(integer(random, least, most));
        return Point_set_case{family, seed, point_set(family, n, random, duplicates)};
    });
}

/// Any of the families.
inline rc::Gen<Bicell_case> bicell_case() {
    return rc::gen::map(seeds(), [](std::uint64_t seed) {
        Random random(seed);
        const Bicell_family family = all_bicell_families[random() % all_bicell_families.size()];
        return Bicell_case{family, seed, bicell(family, random)};
    });
}

inline rc::Gen<Triangle_case> triangle_case() {
    return rc::gen::map(seeds(), [](std::uint64_t seed) {
        Random random(seed);
        const Triangle_family family = all_triangle_families[random() % all_triangle_families.size()];
        return Triangle_case{family, seed, triangle(family, random)};
    });
}

}  // namespace annulus::testing

namespace rc {

template <>
struct Arbitrary<annulus::testing::Seed> {
    static Gen<annulus::testing::Seed> arbitrary() {
        return gen::map(annulus::testing::seeds(), [](std::uint64_t s) { return annulus::testing::Seed{s}; });
    }
};

template <>
struct Arbitrary<annulus::testing::Bicell_case> {
    static Gen<annulus::testing::Bicell_case> arbitrary() { return annulus::testing::bicell_case(); }
};

template <>
struct Arbitrary<annulus::testing::Triangle_case> {
    static Gen<annulus::testing::Triangle_case> arbitrary() { return annulus::testing::triangle_case(); }
};

}  // namespace rc
