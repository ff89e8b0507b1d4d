// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "timing.h"

#include "../motions/random.h"

#include <annulus/predicate/exact_sign.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace bench {

/// Seconds of an exact sign that the filter stage left open, by what decides it.
template <int d>
class Sign_costs {
  public:
    explicit Sign_costs(std::uint64_t seed) : random_(seed) {}

    /// Integers of fixed width: points off the unit sphere by 1e-16, and off a lattice by an ulp; the geometric mean.
    double integers() {
        const double sphere = of([](const annulus::Staged_sign& s) { return is_exact(s, false); },
                                 [this](auto& x) {
                                     for (auto& p : x) {
                                         double square = 0.0;
                                         for (double& c : p) {
                                             c = random_.normal();
                                             square += c * c;
                                         }
                                         for (double& c : p) c /= std::sqrt(square);
                                     }
                                 });
        const double lattice =
            of([](const annulus::Staged_sign& s) { return is_exact(s, false); },
               [this](auto& x) {
                   for (auto& p : x)
                       for (double& c : p) c = static_cast<double>(3 + random_.bits() % 2) * (1.0 + 0x1p-52 * digit());
               });
        return std::sqrt(sphere * lattice);
    }
    /// Intervals: random points, one of them with a coordinate that no common grid has.
    double interval() {
        return of([](const annulus::Staged_sign& s) { return s.stage == annulus::Stage::interval; },
                  [this](auto& x) {
                      for (auto& p : x)
                          for (double& c : p) c = random_.normal();
                      x[0][0] = 0x1p-140;
                  });
    }
    /// Integers of any size: corners of a box that is so thin.
    double exact() {
        return of([](const annulus::Staged_sign& s) { return is_exact(s, true); },
                  [this](auto& x) {
                      for (auto& p : x) {
                          for (double& c : p) c = digit();
                          p[0] *= 0x1p-140;
                      }
                  });
    }

  private:
    using Points = std::array<annulus::Coordinates<d>, static_cast<std::size_t>(d + 2)>;

    static bool is_exact(const annulus::Staged_sign& s, bool of_any_size) {
        return s.stage == annulus::Stage::exact && s.of_any_size == of_any_size;
    }
    double digit() { return static_cast<double>(random_.bits() % 2); }

    /// Of those of the points that `draw` makes for which `is_wanted` holds.
    template <class Wanted, class Draw>
    double of(Wanted is_wanted, Draw draw) {
        constexpr std::size_t count = 512;
        std::vector<Points> points(count);
        for (Points& x : points) do {
                draw(x);
            } while (!is_wanted(sign(x)));
        int sum = 0;
        const double s = least(5, [&] {
            for (const Points& x : points) sum += sign(x).sign;
        });
        return sum == 1 << 20 ? 0.0 : s / static_cast<double>(count);
    }
    static annulus::Staged_sign sign(const Points& x) {
        annulus::Tuple<d, d + 2> t;
        for (std::size_t i = 0; i < t.size(); ++i) t[i] = &x[i];
        return annulus::exact_empty_sphere_sign(t);
    }

    Random random_;
};

}  // namespace bench
