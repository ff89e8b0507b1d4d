// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Generators for RapidCheck. A case carries its seed and prints itself as C++ code, because RapidCheck's reproduce
// strings do not work through Catch. These cases do not shrink, because a smaller seed is not a simpler case; programs
// of calls have their own shrinker (fuzz/common/shrink.h).

#include <support/generators.h>
#include <support/properties.h>

#include <rapidcheck.h>

#include <cstdint>
#include <ostream>

namespace annulus::testing {

struct Point_set_case {
    Family family;
    std::uint64_t seed;
    Points points;
};

inline void showValue(const Point_set_case& c, std::ostream& out) {
    out << name_of(c.family) << ", seed " << c.seed << ", " << c.points.size() << " points\n" << as_code(c.points);
}

/// 64 random bits, whatever RapidCheck's size parameter is.
inline rc::Gen<std::uint64_t> seeds() {
    return rc::gen::noShrink(rc::gen::resize(rc::kNominalSize, rc::gen::arbitrary<std::uint64_t>()));
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

}  // namespace annulus::testing

namespace rc {

template <>
struct Arbitrary<annulus::testing::Seed> {
    static Gen<annulus::testing::Seed> arbitrary() {
        return gen::map(annulus::testing::seeds(), [](std::uint64_t s) { return annulus::testing::Seed{s}; });
    }
};

}  // namespace rc
