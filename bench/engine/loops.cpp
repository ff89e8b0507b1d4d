// SPDX-License-Identifier: GPL-3.0-or-later
// The hot loops, each once on fixed inputs, between markers for Callgrind (bench/instructions runs it). It uses the
// parts of the engine, since the engine itself refuses to run where directed rounding has no effect, as under Valgrind.
// Intervals are a little too narrow there. Nothing here relies on them, and the number of instructions differs only for
// a few certificates in a million.
#include "workbench.h"

#include <annulus/engine/sign_evaluator.h>

#include <valgrind/callgrind.h>

#include <cstdio>
#include <string>

namespace {

using namespace annulus;
using bench::Workbench;

/// Counts the instructions of f, which returns the number of units.
template <class F>
void count(int d, const std::string& name, const char* unit, F f) {
    const std::string mark = std::to_string(d) + "D " + name;
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    const double units = f();
    CALLGRIND_DUMP_STATS_AT(mark.c_str());
    CALLGRIND_STOP_INSTRUMENTATION;
    std::printf("%s\t%.17g\t%s\n", mark.c_str(), units, unit);
}

/// Eight steps.
template <int d>
std::vector<bench::Points<d>> way(Workbench<d>& w, double spacings) {
    std::vector<bench::Points<d>> x;
    for (int k = 0; k < 8; ++k) {
        w.walk(spacings);
        x.push_back(w.points());
    }
    return x;
}

template <int d>
Move_result follow(Workbench<d>& w, const std::vector<bench::Points<d>>& way) {
    Move_result report;
    for (const auto& x : way) w.strategy().move_all(x, report);
    return report;
}

template <int d>
void loops(std::size_t n) {
    const auto all = static_cast<double>(n);
    Workbench<d> w("uniform", n);
    typename Workbench<d>::Mesh fresh;
    const bench::Points<d> start = w.points();
    count(d, "construction", "vertex", [&] { return fresh.build(start), all; });
    count(d, "rebuild", "vertex", [&] { return fresh.rebuild(start), all; });
    count(d, "recomputation", "vertex", [&] { return w.recompute_tolerances(), all; });
    w.walk(1e-9);
    count(d, "step, all pass", "vertex", [&] { return (void)w.step(), all; });

    // Expiring tolerances, hardly ever with a flip.
    const double short_way = d == 2 ? 1e-3 : 1e-4;
    (void)follow(w, way(w, short_way));
    const auto near = way(w, short_way);
    count(d, "expired certificates", "evaluated",
          [&] { return static_cast<double>(follow(w, near).statistics.evaluated); });

    w.drop_tolerances();
    Sign_evaluator<d> signs(w.mesh().table());
    count(d, "signs of everything", "vertex", [&] {
        Budget budget;
        signs.begin(w.points(), budget);
        signs.test_all_cells();
        return all;
    });
    w.walk(1e-9);
    count(d, "step of signs, all hold", "vertex", [&] { return (void)w.step(), all; });
    // Including the signs around them.
    w.drop_tolerances();
    const auto far = way(w, 0.03);
    count(d, "step of signs and flips", "flip", [&] { return static_cast<double>(follow(w, far).statistics.flips); });

    w.recompute_tolerances();
    Move_result report;
    const double reach = 0.01 * w.spacing();
    count(d, "one vertex by 0.01 spacings", "move", [&] {
        for (std::size_t k = 0; k < 500; ++k) {
            const std::size_t v = 7919 * k % n;
            auto p = w.strategy().positions()[v];
            p[0] += reach;
            w.strategy().move(static_cast<Index>(v), p, report);
        }
        return 500.0;
    });
}

}  // namespace

int main() {
    loops<3>(4000);
    loops<2>(10000);
}
