// SPDX-License-Identifier: GPL-3.0-or-later
// A time step of 10,000 uniform points: when every vertex passes, against reading and comparing the arrays; and under
// rebuild, relocate and tolerances at displacements of 1e-4 to 0.3 spacings.
#include <annulus/engine/displacement.h>
#include <annulus/moving_delaunay_2.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

using namespace annulus;

namespace {

constexpr std::size_t n = 10000;
using Points = std::vector<Coordinates<2>>;

double unit(std::mt19937_64& random) { return std::ldexp(static_cast<double>(random() >> 11), -53); }

Points uniform() {
    std::mt19937_64 random(1);
    Points x(n);
    for (auto& p : x) p = {unit(random), unit(random)};
    return x;
}

Points shaken(Points x, double reach, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    for (auto& p : x)
        for (double& c : p) c += reach * (2.0 * unit(random) - 1.0);
    return x;
}

void vertices(benchmark::State& state) { state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(n)); }

/// Two frames so close that no vertex leaves its tolerance.
std::array<Points, 2> within_tolerance(const Moving_delaunay_2& dt, const Points& x) {
    std::array<Points, 2> y{x, x};
    for (std::size_t i = 0; i < n; ++i) {
        const double s = dt.tolerance(dt.vertex(i));
        y[0][i][0] += 0.5 * s;
        y[1][i][1] -= 0.5 * s;
    }
    return y;
}

void every_vertex_passes(benchmark::State& state) {
    const Points x = uniform();
    Moving_delaunay_2 dt(x);
    const auto y = within_tolerance(dt, x);
    std::size_t turn = 0;
    std::uint64_t evaluated = 0;
    for (auto _ : state) evaluated += dt.move_all(y[++turn % 2]).statistics.evaluated;
    if (evaluated != 0) state.SkipWithError("a certificate was evaluated");
    vertices(state);
}
BENCHMARK(every_vertex_passes);

/// The minimum work of any strategy with tolerances: read the position, fixed position and tolerance of every vertex,
/// and compare.
void read_and_compare(benchmark::State& state) {
    const Points x = uniform();
    const Moving_delaunay_2 dt(x);
    const auto y = within_tolerance(dt, x);
    std::vector<double> threshold(n);
    for (std::size_t i = 0; i < n; ++i) threshold[i] = std::pow(dt.tolerance(dt.vertex(i)), 2);
    std::size_t turn = 0;
    for (auto _ : state) {
        const Points& m = y[++turn % 2];
        std::size_t failed = 0;
        for (std::size_t i = 0; i < n; ++i) failed += squared_distance<2>(m[i], x[i]) < threshold[i] ? 0U : 1U;
        benchmark::DoNotOptimize(failed);
    }
    vertices(state);
}
BENCHMARK(read_and_compare);

/// range(0): displacement in units of 1e-4 spacings.
void time_steps(benchmark::State& state, Strategy strategy) {
    Options options;
    options.strategy = strategy;
    const Points x = uniform();
    Moving_delaunay_2 dt(x, options);
    const double reach = 1e-4 * static_cast<double>(state.range(0)) / std::sqrt(static_cast<double>(n));
    std::vector<Points> frames;
    for (std::uint64_t k = 0; k < 16; ++k) frames.push_back(shaken(k == 0 ? x : frames.back(), reach, k + 2));
    for (std::size_t k = frames.size() - 1; k-- > 1;) frames.push_back(frames[k]);  // and back again
    std::size_t frame = 0;
    Move_result report;
    for (auto _ : state) report += dt.move_all(frames[frame++ % frames.size()]);
    vertices(state);
    const double moved = static_cast<double>(report.moves.asked);
    state.counters["evaluated"] = static_cast<double>(report.statistics.evaluated) / moved;
    state.counters["flips"] = static_cast<double>(report.statistics.flips) / moved;
}

void displacements(benchmark::internal::Benchmark* b) {
    for (const int d : {1, 10, 100, 300, 1000, 3000}) b->Arg(d);
}
BENCHMARK_CAPTURE(time_steps, rebuild, Strategy::rebuild)->Apply(displacements)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(time_steps, relocate, Strategy::relocate)->Apply(displacements)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(time_steps, tolerances, Strategy::tolerances)->Apply(displacements)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(time_steps, tolerances_each, Strategy::tolerances_each)
    ->Apply(displacements)
    ->Unit(benchmark::kMillisecond);

}  // namespace
