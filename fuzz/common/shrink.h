// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// Shrinks a failing program: fewer operations, then fewer points, then simpler ones. Greedy: every change that still
// fails is kept. Symbolic operations stay legal when others are removed (operation.h), so most attempts are useful.

#include "operation.h"

#include <chrono>
#include <cmath>

namespace annulus::oracle {

/// The complexity of a number: 0 has none, small integers have little, doubles with many bits the most.
[[nodiscard]] inline int complexity(double x) {
    if (x == 0.0) return std::signbit(x) ? 2 : 0;
    if (!std::isfinite(x)) return 1;
    int exponent = 0;
    double m = std::frexp(std::fabs(x), &exponent);
    int bits = 0;
    for (; m != std::floor(m); m *= 2) ++bits;
    const int binade = exponent - bits;  // x is an odd integer times 2^binade
    return (x < 0 ? 3 : 2) + 2 * bits + std::abs(binade) + (binade < 0 ? 1 : 0);
}

template <int d, class Fails>
class Shrinker {
  public:
    using Program = Program_of<d>;
    using Operation = Operation_of<d>;

    Shrinker(Program program, Fails fails, int runs, std::chrono::seconds patience)
        : best_(std::move(program)), fails_(std::move(fails)), runs_(runs), until_(Clock::now() + patience) {}

    [[nodiscard]] Program result() {
        while (int{drop_operations()} + simplify_operations() + drop_points() + simplify_numbers() > 0)
            if (spent()) break;
        return best_;
    }

  private:
    using Clock = std::chrono::steady_clock;

    [[nodiscard]] bool spent() const { return runs_ <= 0 || Clock::now() > until_; }

    bool keep_if_it_fails(Program candidate) {
        if (spent()) return false;
        --runs_;
        if (!fails_(candidate)) return false;
        best_ = std::move(candidate);
        return true;
    }
    /// Halves first, then single ones, from the end: operations after the fault are removed at once.
    template <class Without>
    bool drop(std::size_t count, Without without) {
        bool any = false;
        for (std::size_t length = std::max<std::size_t>(1, count / 2); !spent(); length /= 2) {
            for (std::size_t end = count; end > 0 && !spent();) {
                const std::size_t begin = end - std::min(end, length);
                if (end <= count && keep_if_it_fails(without(begin, end))) {
                    count -= end - begin;
                    any = true;
                }
                end = begin;
            }
            if (length <= 1) break;
        }
        return any;
    }
    bool drop_operations() {
        return drop(best_.operations.size(), [this](std::size_t begin, std::size_t end) {
            Program p = best_;
            p.operations.erase(p.operations.begin() + static_cast<std::ptrdiff_t>(begin),
                               p.operations.begin() + static_cast<std::ptrdiff_t>(end));
            return p;
        });
    }
    /// Vertices after the removed points have other indices.
    bool drop_points() {
        return drop(best_.points.size(), [this](std::size_t begin, std::size_t end) {
            Program p = best_;
            const auto cut = [begin, end](std::vector<Coordinates<d>>& x) {
                x.erase(x.begin() + static_cast<std::ptrdiff_t>(std::min(begin, x.size())),
                        x.begin() + static_cast<std::ptrdiff_t>(std::min(end, x.size())));
            };
            cut(p.points);
            for (Operation& o : p.operations) {
                if (o.kind == Operation_kind::move_all) cut(o.points);
                if (o.vertex >= static_cast<Index>(end)) o.vertex -= static_cast<Index>(end - begin);
            }
            return p;
        });
    }
    bool try_operation(std::size_t i, const Operation& o) {
        Program p = best_;
        p.operations[i] = o;
        return keep_if_it_fails(std::move(p));
    }
    bool simplify_operations() {
        bool any = false;
        for (std::size_t i = best_.operations.size(); i-- > 0 && !spent();) {
            const auto alter = [&](auto change) {
                for (;;) {
                    Operation o = best_.operations[i];
                    if (!change(o) || !try_operation(i, o)) return;
                    any = true;
                }
            };
            if (best_.operations[i].kind == Operation_kind::steady) {
                alter([](Operation& o) { return o.times > 1 && (o.times /= 2, true); });
                alter([](Operation& o) { return o.times > 1 && (--o.times, true); });
                alter([](Operation& o) {
                    return o.seed > 1 && (o.seed %= std::max<std::uint64_t>(2, o.seed / 2), true);
                });
                alter([](Operation& o) { return round_pace(o.pace); });
            }
            if (best_.operations[i].kind == Operation_kind::refused || best_.operations[i].fits)
                alter([](Operation& o) { return o.vertex > 0 && (o.vertex /= 2, true); });
        }
        return any;
    }
    static bool round_pace(double& pace) {
        const double power = std::ldexp(1.0, std::ilogb(pace));
        if (!std::isfinite(pace) || pace == 0.0 || power == pace) return false;
        pace = power;
        return true;
    }

    /// All numbers of a kind at once, then one after another.
    bool simplify_numbers() {
        bool any = false;
        for (const int bits : {0, 4, 10, 20, 30}) any |= everywhere([bits](double x) { return rounded(x, bits); });
        for (const int bits : {1, 3, 6, 12, 24}) any |= everywhere([bits](double x) { return shortened(x, bits); });
        const auto numbers = [this] {
            std::size_t n = best_.points.size();
            for (const Operation& o : best_.operations) n += o.points.size();
            return n * static_cast<std::size_t>(d);
        };
        for (std::size_t i = 0; i < numbers() && !spent(); ++i)
            for (bool smaller = true; smaller && !spent();) {
                smaller = false;
                const double x = number(best_, i);
                for (const double y : {0.0, 1.0, std::nearbyint(x), rounded(x, 4), shortened(x, 3), shortened(x, 12),
                                       shortened(x, 26), std::fabs(x), 0.5 * x}) {
                    if (complexity(y) >= complexity(x)) continue;
                    Program p = best_;
                    number(p, i) = y;
                    if (!keep_if_it_fails(std::move(p))) continue;
                    any = smaller = true;
                    break;
                }
            }
        return any;
    }
    /// A multiple of 2^-bits.
    static double rounded(double x, int bits) { return std::ldexp(std::nearbyint(std::ldexp(x, bits)), -bits); }
    /// The leading bits.
    static double shortened(double x, int bits) {
        if (x == 0.0 || !std::isfinite(x)) return x;
        const int k = bits - 1 - std::ilogb(x);
        return std::scalbn(std::nearbyint(std::scalbn(x, k)), -k);
    }
    template <class Change>
    bool everywhere(Change change) {
        Program p = best_;
        bool changed = false;
        const auto all = [&](std::vector<Coordinates<d>>& points) {
            for (auto& point : points)
                for (double& x : point) {
                    const double y = change(x);
                    if (complexity(y) >= complexity(x)) continue;
                    x = y;
                    changed = true;
                }
        };
        all(p.points);
        for (Operation& o : p.operations) all(o.points);
        return changed && keep_if_it_fails(std::move(p));
    }
    static double& number(Program& p, std::size_t i) {
        std::size_t point = i / static_cast<std::size_t>(d);
        const std::size_t c = i % static_cast<std::size_t>(d);
        if (point < p.points.size()) return p.points[point][c];
        point -= p.points.size();
        for (Operation& o : p.operations) {
            if (point < o.points.size()) return o.points[point][c];
            point -= o.points.size();
        }
        return p.points[0][0];  // not reached: i is below their number
    }

    Program best_;
    Fails fails_;
    int runs_;
    Clock::time_point until_;
};

/// Shrinks a program for which fails() is true, keeping it true. Stops after this many runs or this much time.
template <int d, class Fails>
[[nodiscard]] Program_of<d> shrunk(const Program_of<d>& program, Fails fails, int runs = 3000,
                                   std::chrono::seconds patience = std::chrono::seconds(10)) {
    return Shrinker<d, Fails>(program, std::move(fails), runs, patience).result();
}

}  // namespace annulus::oracle
