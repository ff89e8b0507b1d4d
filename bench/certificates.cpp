// SPDX-License-Identifier: GPL-3.0-or-later
// Nanoseconds per half width: each stage, each family of bi-cells, and plain double of the same formula.
#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/certificate/ladder.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

using namespace annulus;

namespace {

struct Bicell {
    std::array<Coordinates<2>, 4> x;
    [[nodiscard]] Tuple<2, 4> tuple() const { return {&x[0], &x[1], &x[2], &x[3]}; }
    [[nodiscard]] Tuple<2, 3> triangle() const { return {&x[0], &x[1], &x[3]}; }
};

enum Family { uniform, near_cocircular, noisy_grid, cocircular };
constexpr std::array<const char*, 4> names{"uniform", "near cocircular", "noisy grid", "cocircular"};

std::vector<Bicell> bicells(Family family) {
    std::mt19937_64 random(1);
    const auto unit = [&] { return std::ldexp(static_cast<double>(random() >> 11), -53); };
    std::vector<Bicell> cells;
    while (cells.size() < 1024) {
        Bicell c{};
        switch (family) {
            case uniform: c.x = {{{unit(), unit()}, {unit(), unit()}, {unit(), unit()}, {unit(), unit()}}}; break;
            case near_cocircular: {
                // Counter-clockwise a, p, b, q, off the circle by about 1e-11.
                const std::array<double, 4> turn{0.1 * unit(), 0.5 + 0.1 * unit(), 0.25 + 0.1 * unit(),
                                                 0.75 + 0.1 * unit()};
                for (std::size_t i = 0; i < 4; ++i) {
                    const double r = 1.0 + 1e-11 * unit();
                    c.x[i] = {r * std::cos(6.283185307 * turn[i]), r * std::sin(6.283185307 * turn[i])};
                }
                break;
            }
            case noisy_grid:
            case cocircular: {
                c.x = {{{0, 0}, {1, 1}, {1, 0}, {0, 1}}};
                if (family == noisy_grid)
                    for (auto& p : c.x)
                        for (double& v : p) v += std::ldexp(unit() - 0.5, -50);
                break;
            }
        }
        if (orientation_exact({&c.x[0], &c.x[1], &c.x[3]}).sign < 0) std::swap(c.x[0], c.x[1]);
        if (orientation_exact({&c.x[0], &c.x[1], &c.x[3]}).sign <= 0) continue;
        if (orientation_exact({&c.x[1], &c.x[0], &c.x[2]}).sign <= 0) continue;
        if (family != cocircular && empty_sphere_exact(c.tuple()).sign <= 0) {
            c.x = {c.x[2], c.x[3], c.x[1], c.x[0]};
            if (orientation_exact({&c.x[0], &c.x[1], &c.x[3]}).sign <= 0) continue;
            if (orientation_exact({&c.x[1], &c.x[0], &c.x[2]}).sign <= 0) continue;
            if (empty_sphere_exact(c.tuple()).sign <= 0) continue;
        }
        cells.push_back(c);
    }
    return cells;
}

void count(benchmark::State& state, std::size_t a_round) {
    state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(a_round));
    state.SetLabel(names[static_cast<std::size_t>(state.range(0))]);
}

template <class Evaluate>
void over_all(benchmark::State& state, Evaluate evaluate) {
    const auto cells = bicells(static_cast<Family>(state.range(0)));
    for (auto _ : state) {
        double sum = 0.0;
        for (const Bicell& c : cells) sum += evaluate(c);
        benchmark::DoNotOptimize(sum);
    }
    count(state, cells.size());
}

/// The formula of the filter without error bounds.
double plain(const Bicell& c) {
    const auto b = detail::difference(c.x[1], c.x[0]);
    const auto p = detail::difference(c.x[2], c.x[0]);
    const auto q = detail::difference(c.x[3], c.x[0]);
    const auto e = detail::difference(c.x[3], c.x[2]);
    const auto t = annulus_terms(b, p, q, e);
    return t.determinant / (std::sqrt(t.inner) + std::sqrt(t.outer));
}

void half_width_plain(benchmark::State& state) { over_all(state, plain); }
BENCHMARK(half_width_plain)->DenseRange(uniform, cocircular);

void half_width_filter(benchmark::State& state) {
    over_all(state, [](const Bicell& c) {
        Verdict v;
        return empty_sphere_filter(c.tuple(), true, v) ? v.tolerance : 0.0;
    });
}
BENCHMARK(half_width_filter)->DenseRange(uniform, cocircular);

void half_width_interval_guard_per_batch(benchmark::State& state) {
    const auto cells = bicells(static_cast<Family>(state.range(0)));
    for (auto _ : state) {
        const Rounding_guard guard(FE_UPWARD);
        for (const Bicell& c : cells) {
            Verdict v;
            benchmark::DoNotOptimize(empty_sphere_interval(c.tuple(), v));
            benchmark::DoNotOptimize(v.tolerance);
        }
    }
    count(state, cells.size());
}
BENCHMARK(half_width_interval_guard_per_batch)->DenseRange(uniform, cocircular);

void half_width_interval_guard_per_call(benchmark::State& state) {
    over_all(state, [](const Bicell& c) {
        const Rounding_guard guard(FE_UPWARD);
        Verdict v;
        benchmark::DoNotOptimize(empty_sphere_interval(c.tuple(), v));
        return v.tolerance;
    });
}
BENCHMARK(half_width_interval_guard_per_call)->DenseRange(uniform, cocircular);

void half_width_exact(benchmark::State& state) {
    over_all(state, [](const Bicell& c) { return empty_sphere_exact(c.tuple()).tolerance; });
}
BENCHMARK(half_width_exact)->DenseRange(uniform, cocircular);

void half_width_ladder(benchmark::State& state) {
    over_all(state, [](const Bicell& c) { return empty_sphere_verdict(c.tuple()).tolerance; });
}
BENCHMARK(half_width_ladder)->DenseRange(uniform, cocircular);

void half_altitude_filter(benchmark::State& state) {
    over_all(state, [](const Bicell& c) {
        Verdict v;
        return orientation_filter(c.triangle(), true, v) ? v.tolerance : 0.0;
    });
}
BENCHMARK(half_altitude_filter)->Arg(uniform);

void half_altitude_exact(benchmark::State& state) {
    over_all(state, [](const Bicell& c) { return orientation_exact(c.triangle()).tolerance; });
}
BENCHMARK(half_altitude_exact)->Arg(uniform);

}  // namespace
