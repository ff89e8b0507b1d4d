// SPDX-License-Identifier: GPL-3.0-or-later
#include <support/point_sets_3.h>

#include <support/generators_3.h>

#include <cmath>
#include <set>

namespace annulus::testing {

namespace {

using Place = Coordinates<3>;

Place uniform(Random& random) {
    return {between(random, -1.0, 1.0), between(random, -1.0, 1.0), between(random, -1.0, 1.0)};
}

Place on_sphere(Random& random) {
    for (;;) {
        Place p = uniform(random);
        const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
        if (r < 0.1 || r > 1.0) continue;
        for (double& c : p) c /= r;
        return p;
    }
}

/// All integer points of this squared norm.
Points_3 of_norm(int norm) {
    Points_3 points;
    for (int i = -9; i <= 9; ++i)
        for (int j = -9; j <= 9; ++j)
            for (int k = -9; k <= 9; ++k)
                if (i * i + j * j + k * k == norm)
                    points.push_back({static_cast<double>(i), static_cast<double>(j), static_cast<double>(k)});
    return points;
}

/// One more point of the family, placed relative to the existing ones.
Place point_of(Set_3 set, const Points_3& have, Random& random) {
    switch (set) {
        case Set_3::uniform: return uniform(random);
        case Set_3::lattice:
        case Set_3::noisy_lattice: {
            Place p{};
            for (double& c : p) c = integer(random, 0, 4);
            if (set == Set_3::noisy_lattice)
                for (double& c : p)
                    if (random() % 2 == 0) c = std::nextafter(c, random() % 2 == 0 ? 9.0 : -9.0);
            return p;
        }
        case Set_3::cube: {
            const double size = integer(random, 1, 8);
            const Place corner{random() % 2 == 0 ? 0.0 : size, random() % 2 == 0 ? 0.0 : size,
                               random() % 2 == 0 ? 0.0 : 2.0 * size};
            return corner;
        }
        case Set_3::sphere: {
            static const Points_3 points = of_norm(65);
            if (have.size() >= points.size())
                return {integer(random, -9, 9) / 16.0, integer(random, -9, 9) / 16.0, 0.5};
            return points[random() % points.size()];
        }
        case Set_3::near_sphere: {
            Place p = on_sphere(random);
            const double off = 1.0 + std::ldexp(between(random, -1.0, 1.0), -integer(random, 20, 60));
            for (double& c : p) c *= off;
            return p;
        }
        case Set_3::rough_sphere: {
            Place p = on_sphere(random);
            if (!have.empty() && random() % 2 == 0) {  // near an existing one
                const double share = std::ldexp(1.0, -integer(random, 1, 4));
                for (std::size_t k = 0; k < 3; ++k) p[k] = have[0][k] + share * (p[k] - have[0][k]);
                const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
                for (double& c : p) c /= r;
            }
            const double off = 1.0 + std::ldexp(between(random, -1.0, 1.0), -integer(random, 10, 40));
            for (double& c : p) c *= off;
            return p;
        }
        case Set_3::subnormal: {
            Place p{};
            for (double& c : p)
                c = std::ldexp(static_cast<double>(integer(random, -300, 300)), random() % 8 == 0 ? -1050 : -1074);
            return p;
        }
        case Set_3::huge: {
            Place p = uniform(random);
            if (have.size() < 4)
                for (std::size_t k = 0; k < 3; ++k) p[k] = (have.size() == 3 || have.size() == k) ? 1.0 : -1.0;
            for (double& c : p) c = std::ldexp(c, 500);
            return p;
        }
        case Set_3::far_offset: {
            const bool positive = have.empty() ? random() % 2 == 0 : have[0][0] > 0.0;
            Place p{};
            for (double& c : p) c = (positive ? 0x1p40 : -0x1p40) + integer(random, 0, 6);
            return p;
        }
        case Set_3::mixed_scales: {
            Place p{};
            for (double& c : p) c = any_in_domain(random);
            return p;
        }
        case Set_3::plane:
            return {static_cast<double>(integer(random, 0, 30)), static_cast<double>(integer(random, 0, 30)), 3.0};
        case Set_3::near_plane: {
            Place p = uniform(random);
            p[2] = std::ldexp(p[2], -integer(random, 10, 50));
            return p;
        }
        case Set_3::line: {
            const double k = integer(random, -500, 500);
            return {k, 2.0 * k, 1.0 - k};
        }
        case Set_3::clustered: {
            const Place p = have.empty() || random() % 4 == 0 ? uniform(random) : have[random() % have.size()];
            const Place q = uniform(random);
            const int small = -integer(random, 3, 30);
            return {p[0] + std::ldexp(q[0], small), p[1] + std::ldexp(q[1], small), p[2] + std::ldexp(q[2], small)};
        }
        case Set_3::slivers: {
            const double turn = between(random, 0.0, 6.283185307179586);
            const int floor = integer(random, 0, 3);
            return {std::cos(turn), std::sin(turn),
                    floor + std::ldexp(between(random, -1.0, 1.0), -integer(random, 10, 40))};
        }
        case Set_3::scaled: break;
    }
    return uniform(random);
}

}  // namespace

std::string_view name_of(Set_3 set) {
    constexpr std::array<std::string_view, all_sets_3.size()> names{
        "uniform",       "lattice", "cube",       "sphere",       "near-sphere", "rough-sphere",
        "noisy-lattice", "plane",   "near-plane", "line",         "clustered",   "slivers",
        "subnormal",     "huge",    "far-offset", "mixed-scales", "scaled"};
    return names[static_cast<std::size_t>(set)];
}

Points_3 point_set(Set_3 set, std::size_t n, Random& random) {
    int exponent = 0;
    if (set == Set_3::scaled) {
        do set = all_sets_3[random() % (all_sets_3.size() - 1)];
        while (set == Set_3::subnormal || set == Set_3::huge || set == Set_3::mixed_scales);
        exponent = integer(random, -400, 400);
    }
    std::set<Place> seen;
    Points_3 unscaled;  // some families continue from the points they have
    Points_3 points;
    for (std::size_t attempts = 0; points.size() < n; ++attempts) {
        const Place p = attempts < 20 * n ? point_of(set, unscaled, random) : uniform(random);
        Place scaled = p;
        for (double& c : scaled) c = std::ldexp(c + 0.0, exponent);
        if (!seen.insert(scaled).second) continue;  // after scaling: the least numbers may vanish
        unscaled.push_back(p);
        points.push_back(scaled);
    }
    return points;
}

std::string as_code(const Points_3& points) {
    std::string s = "{";
    for (const Place& p : points) s += (s.size() > 1 ? ", " : "") + as_code(p);
    return s + "}";
}

}  // namespace annulus::testing
