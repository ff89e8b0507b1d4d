// SPDX-License-Identifier: GPL-3.0-or-later
// Nanoseconds per half width: each stage, each family of bi-cells, single calls and batches, and the same formula in
// plain double.
#include <annulus/arithmetic/rounding_guard.h>
#include <annulus/predicate/filtered.h>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <span>
#include <vector>

using namespace annulus;

namespace {

enum Family { uniform, near_cospherical, noisy_grid, cospherical };
constexpr std::array<const char*, 4> names{"uniform", "near cospherical", "noisy grid", "cospherical"};

/// 1024 bi-cells of a family, both cells positive, the sphere empty (or through all points), and a cell of each.
template <int d>
struct Cases {
    static constexpr std::size_t count = 1024;
    using Points = std::array<Coordinates<d>, d + 2>;
    std::vector<Points> points;
    std::vector<Tuple<d, d + 2>> bicells;
    std::vector<Tuple<d, d + 1>> cells;
    std::vector<Certificate_value> verdicts{count};

    explicit Cases(Family family) {
        std::mt19937_64 random(1);
        while (points.size() < count) add(draw(family, random), family, random);
        for (const Points& x : points) {
            bicells.push_back(bicell(x));
            cells.push_back(cell_q(x));
        }
    }

  private:
    static double unit(std::mt19937_64& random) { return std::ldexp(static_cast<double>(random() >> 11), -53); }

    static Points draw(Family family, std::mt19937_64& random) {
        Points x{};
        for (std::size_t i = 0; i < x.size(); ++i) switch (family) {
                case uniform:
                    for (double& c : x[i]) c = unit(random);
                    break;
                case near_cospherical: {  // off the unit sphere by about 1e-11
                    double square = 0.0;
                    for (double& c : x[i]) c = 2.0 * unit(random) - 1.0;
                    for (const double c : x[i]) square += c * c;
                    for (double& c : x[i]) c *= (1.0 + 1e-11 * unit(random)) / std::sqrt(square);
                    break;
                }
                case noisy_grid:
                case cospherical:  // corners of a cube
                    for (double& c : x[i]) c = static_cast<double>(random() % 2);
                    if (family == noisy_grid)
                        for (double& c : x[i]) c += std::ldexp(unit(random) - 0.5, -50);
                    break;
            }
        return x;
    }

    template <std::size_t... i>
    static Tuple<d, d + 2> bicell(const Points& x, std::index_sequence<i...>) {
        return {&x[i]...};
    }
    static Tuple<d, d + 2> bicell(const Points& x) { return bicell(x, std::make_index_sequence<d + 2>()); }
    static Tuple<d, d + 1> cell_q(const Points& x) {
        if constexpr (d == 2) return {&x[0], &x[1], &x[3]};
        else return {&x[0], &x[1], &x[2], &x[4]};
    }
    static Tuple<d, d + 1> cell_p(const Points& x) {
        if constexpr (d == 2) return {&x[1], &x[0], &x[2]};
        else return {&x[1], &x[0], &x[2], &x[3]};
    }
    void add(Points x, Family family, std::mt19937_64& random) {
        for (int tries = 0; tries < 200; ++tries) {
            std::shuffle(x.begin(), x.end(), random);
            if (orientation_exact(cell_q(x)).sign <= 0 || orientation_exact(cell_p(x)).sign <= 0) continue;
            if (empty_sphere_exact(bicell(x)).sign <= (family == cospherical ? -1 : 0)) continue;
            points.push_back(x);
            return;
        }
    }
};

void label(benchmark::State& state) {
    state.SetItemsProcessed(state.iterations() * 1024);
    state.SetLabel(names[static_cast<std::size_t>(state.range(0))]);
}

template <int d, class Evaluate>
void one_by_one(benchmark::State& state, Evaluate evaluate) {
    const Cases<d> cases(static_cast<Family>(state.range(0)));
    for (auto _ : state) {
        double sum = 0.0;
        for (const auto& x : cases.bicells) sum += evaluate(x);
        benchmark::DoNotOptimize(sum);
    }
    label(state);
}

/// The formula of the filter without error bounds, in plain double.
double plain(const Tuple<2, 4>& x) {
    const auto t = annulus_terms(detail::difference(*x[1], *x[0]), detail::difference(*x[2], *x[0]),
                                 detail::difference(*x[3], *x[0]), detail::difference(*x[3], *x[2]));
    return t.determinant / (std::sqrt(t.inner) + std::sqrt(t.outer));
}
double plain(const Tuple<3, 5>& x) {
    const auto t = annulus_terms(detail::difference(*x[1], *x[0]), detail::difference(*x[2], *x[0]),
                                 detail::difference(*x[3], *x[0]), detail::difference(*x[4], *x[0]));
    const auto sum = detail::norms(t);
    return t.determinant / std::max(std::max(sum[0], sum[1]), std::max(sum[2], sum[3]));
}

template <int d>
void half_width_plain(benchmark::State& state) {
    one_by_one<d>(state, [](const auto& x) { return plain(x); });
}
template <int d>
void half_width_filter(benchmark::State& state) {
    one_by_one<d>(state, [](const auto& x) {
        Certificate_value v;
        return empty_sphere_filter(x, true, v) ? v.tolerance : 0.0;
    });
}
template <int d>
void half_width_interval_guard_per_call(benchmark::State& state) {
    one_by_one<d>(state, [](const auto& x) {
        const Rounding_guard guard(FE_UPWARD);
        Certificate_value v;
        benchmark::DoNotOptimize(empty_sphere_interval(x, v));
        return v.tolerance;
    });
}
template <int d>
void half_width_interval_guard_per_batch(benchmark::State& state) {
    const Cases<d> cases(static_cast<Family>(state.range(0)));
    for (auto _ : state) {
        const Rounding_guard guard(FE_UPWARD);
        for (const auto& x : cases.bicells) {
            Certificate_value v;
            benchmark::DoNotOptimize(empty_sphere_interval(x, v));
            benchmark::DoNotOptimize(v.tolerance);
        }
    }
    label(state);
}
template <int d>
void half_width_exact(benchmark::State& state) {
    one_by_one<d>(state, [](const auto& x) { return empty_sphere_exact(x).tolerance; });
}
template <int d>
void half_width_filtered(benchmark::State& state) {
    one_by_one<d>(state, [](const auto& x) { return evaluate_empty_sphere(x).tolerance; });
}
#define EVERY_FAMILY(function)                                         \
    BENCHMARK_TEMPLATE(function, 2)->DenseRange(uniform, cospherical); \
    BENCHMARK_TEMPLATE(function, 3)->DenseRange(uniform, cospherical)
EVERY_FAMILY(half_width_plain);
EVERY_FAMILY(half_width_filter);
EVERY_FAMILY(half_width_interval_guard_per_call);
EVERY_FAMILY(half_width_interval_guard_per_batch);
EVERY_FAMILY(half_width_exact);
EVERY_FAMILY(half_width_filtered);

/// range(0): family, range(1): Mode.
template <int d>
void half_width_batch(benchmark::State& state) {
    Cases<d> cases(static_cast<Family>(state.range(0)));
    const auto mode = static_cast<Tolerance_precision>(state.range(1));
    for (auto _ : state) {
        evaluate(std::span<const Tuple<d, d + 2>>(cases.bicells), mode, cases.verdicts);
        benchmark::DoNotOptimize(cases.verdicts.data());
        benchmark::ClobberMemory();
    }
    label(state);
}
void family_and_mode(benchmark::internal::Benchmark* b) {
    for (const Tolerance_precision mode :
         {Tolerance_precision::approximate, Tolerance_precision::lower_bound, Tolerance_precision::correctly_rounded})
        for (int family = uniform; family <= cospherical; ++family) b->Args({family, static_cast<int>(mode)});
}
BENCHMARK_TEMPLATE(half_width_batch, 2)->Apply(family_and_mode);
BENCHMARK_TEMPLATE(half_width_batch, 3)->Apply(family_and_mode);

/// range(1): Cell_widths.
void half_width_batch_cells(benchmark::State& state) {
    Cases<3> cases(static_cast<Family>(state.range(0)));
    const auto cells = static_cast<Cell_widths>(state.range(1));
    for (auto _ : state) {
        evaluate(std::span<const Tuple<3, 5>>(cases.bicells), Tolerance_precision::lower_bound, cases.verdicts, cells);
        benchmark::DoNotOptimize(cases.verdicts.data());
        benchmark::ClobberMemory();
    }
    label(state);
    std::int64_t wrong_side = 0;
    for (const Certificate_value& v : cases.verdicts) wrong_side += v.wrong_side != 0;
    state.counters["wrong_side"] = static_cast<double>(wrong_side) / 1024.0;
}
BENCHMARK(half_width_batch_cells)->Args({0, 0})->Args({0, 1})->Args({0, 2});

// ---- Orientation ------------------------------------------------------------------------------------------------

template <int d>
void cell_width_filter(benchmark::State& state) {
    const Cases<d> cases(static_cast<Family>(state.range(0)));
    for (auto _ : state) {
        double sum = 0.0;
        for (const auto& x : cases.cells) {
            Certificate_value v;
            sum += orientation_filter(x, true, v) ? v.tolerance : 0.0;
        }
        benchmark::DoNotOptimize(sum);
    }
    label(state);
}
template <int d>
void cell_width_batch(benchmark::State& state) {
    Cases<d> cases(static_cast<Family>(state.range(0)));
    for (auto _ : state) {
        evaluate(std::span<const Tuple<d, d + 1>>(cases.cells), Tolerance_precision::lower_bound, cases.verdicts);
        benchmark::DoNotOptimize(cases.verdicts.data());
        benchmark::ClobberMemory();
    }
    label(state);
}
template <int d>
void cell_width_exact(benchmark::State& state) {
    const Cases<d> cases(static_cast<Family>(state.range(0)));
    for (auto _ : state) {
        double sum = 0.0;
        for (const auto& x : cases.cells) sum += orientation_exact(x).tolerance;
        benchmark::DoNotOptimize(sum);
    }
    label(state);
}
BENCHMARK_TEMPLATE(cell_width_filter, 2)->Arg(uniform);
BENCHMARK_TEMPLATE(cell_width_filter, 3)->Arg(uniform);
BENCHMARK_TEMPLATE(cell_width_batch, 2)->Arg(uniform);
BENCHMARK_TEMPLATE(cell_width_batch, 3)->Arg(uniform);
BENCHMARK_TEMPLATE(cell_width_exact, 2)->Arg(uniform);
BENCHMARK_TEMPLATE(cell_width_exact, 3)->Arg(uniform);

}  // namespace
