// SPDX-License-Identifier: GPL-3.0-or-later
#include "generators.h"

#include <gmpxx.h>

#include <array>
#include <cmath>

namespace annulus::testing {

double unit(Random& random) { return static_cast<double>(random() >> 11) * 0x1p-53; }

double between(Random& random, double low, double high) { return low + (high - low) * unit(random); }

int integer(Random& random, int low, int high) {
    const auto range = static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1);
    return static_cast<int>(low + static_cast<std::int64_t>(random() % range));
}

double ulp_noise(Random& random, double x, int ulps) {
    for (int k = integer(random, -ulps, ulps); k != 0; k += k > 0 ? -1 : 1)
        x = std::nextafter(x, k > 0 ? HUGE_VAL : -HUGE_VAL);
    return x;
}

double any_in_domain(Random& random) {
    const double sign = random() % 2 == 0 ? 1.0 : -1.0;
    switch (random() % 8) {
        case 0: return random() % 2 == 0 ? sign * 0.0 : sign * 0x1p500;
        case 1: return sign * std::ldexp(1.0, integer(random, -1074, 500));
        case 2: return sign * std::ldexp(unit(random), -1022);
        default: return sign * std::ldexp(0.5 + 0.5 * unit(random), integer(random, -1073, 500));
    }
}

int exact_orientation(const Point& a, const Point& b, const Point& c) {
    const mpq_class ax(a[0]), ay(a[1]), bx(b[0]), by(b[1]), cx(c[0]), cy(c[1]);
    const mpq_class left = (bx - ax) * (cy - ay);
    const mpq_class right = (by - ay) * (cx - ax);
    return (left > right) - (left < right);
}

int exact_empty_circle(const Point& a, const Point& b, const Point& q, const Point& p) {
    // The 3 x 3 determinant of the lifted points with p as the origin, expanded along the column of squares.
    const auto row = [&p](const Point& x) {
        const mpq_class dx = mpq_class(x[0]) - mpq_class(p[0]);
        const mpq_class dy = mpq_class(x[1]) - mpq_class(p[1]);
        const mpq_class lift = dx * dx + dy * dy;
        return std::array<mpq_class, 3>{dx, dy, lift};
    };
    const auto i = row(a), j = row(b), k = row(q);
    const mpq_class inside =
        i[2] * (j[0] * k[1] - j[1] * k[0]) - j[2] * (i[0] * k[1] - i[1] * k[0]) + k[2] * (i[0] * j[1] - i[1] * j[0]);
    return -sgn(inside);
}

}  // namespace annulus::testing
