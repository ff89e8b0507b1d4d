// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Loops over random cases, without RapidCheck: a failing case prints its seed, and programs have their own shrinker.

#include <support/catch.h>
#include <support/generators.h>
#include <support/point_sets_3.h>

#include <cstdlib>
#include <string>
#include <type_traits>

namespace annulus::testing {

/// n, or the share of it that RC_PARAMS's max_success is of RapidCheck's hundred; at least 1.
[[nodiscard]] inline int scaled_cases(int n) {
    const char* const parameters = std::getenv("RC_PARAMS");
    const std::string text = parameters != nullptr ? parameters : "";
    const std::string name = "max_success=";
    const std::size_t at = text.find(name);
    if (at == std::string::npos) return n;
    return std::max(1, n * std::atoi(text.c_str() + at + name.size()) / 100);
}

/// check(random) for about n random generators, whose seeds follow from that of the run.
template <class Check>
void for_each_seed(int n, Check check) {
    Random seeds(run_seed());
    for (int k = scaled_cases(n); k > 0; --k) {
        const std::uint64_t seed = seeds();
        INFO("case of seed " << seed);
        Random random(seed);
        check(random);
    }
}

/// Point sets by dimension, for tests that are the same in 2D and 3D.
template <int d>
using Set_of = std::conditional_t<d == 2, Family, Set_3>;
template <int d>
using Points_of = std::vector<Coordinates<d>>;
template <int d>
[[nodiscard]] constexpr const auto& all_sets() {
    if constexpr (d == 2) return all_families;
    else return all_sets_3;
}
template <int d>
[[nodiscard]] Set_of<d> any_set(Random& random) {
    return all_sets<d>()[random() % all_sets<d>().size()];
}
/// Points of the usual size, whose coordinates are 0 or far from underflow.
template <int d>
[[nodiscard]] Set_of<d> ordinary_set(Random& random) {
    if constexpr (d == 2) {
        constexpr std::array sets{Family::uniform,          Family::grid,
                                  Family::noisy_grid,       Family::cocircular_rounded,
                                  Family::cocircular_exact, Family::cocircular_near,
                                  Family::nearly_collinear, Family::clustered,
                                  Family::far_offset};
        return sets[random() % sets.size()];
    } else {
        constexpr std::array sets{Set_3::uniform,     Set_3::lattice,      Set_3::cube,       Set_3::sphere,
                                  Set_3::near_sphere, Set_3::rough_sphere, Set_3::near_plane, Set_3::clustered,
                                  Set_3::slivers,     Set_3::far_offset};
        return sets[random() % sets.size()];
    }
}
template <int d>
[[nodiscard]] Points_of<d> some_points(Set_of<d> set, int least, int most, Random& random) {
    return point_set(set, static_cast<std::size_t>(integer(random, least, most)), random);
}
template <class T>
void shuffle(std::vector<T>& x, Random& random) {
    for (std::size_t i = x.size(); i > 1; --i) std::swap(x[i - 1], x[random() % i]);
}

}  // namespace annulus::testing
