// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/print_comparison.h>

#include <apps/cli/input.h>
#include <apps/formats/formatted.h>
#include <apps/report/finding.h>

#include <cstdio>

namespace annulus::inline v1::cli {

void print_comparison(const Comparison_record& c) {
    std::printf("%-24s %14s %12s %12s %10s %14s\n", "strategy", "triangulation", "ns/vertex", "within tol.", "audits",
                "construction");
    for (const Run_record& r : c.runs) {
        const auto asked = static_cast<double>(r.moves.asked > 0 ? r.moves.asked : 1);
        const Tested_moves tested = tested_moves(r);
        const std::string within = tested.asked == 0
                                       ? "-"
                                       : formatted("%.2f %%", 100.0 * static_cast<double>(tested.within_tolerance) /
                                                                  static_cast<double>(tested.asked));
        std::printf("%-24s %12.3f s %12.1f %12s %8llu/%llu %12.3f s\n", r.strategy.c_str(), r.seconds.triangulation,
                    r.seconds.triangulation / asked * 1e9, within.c_str(),
                    static_cast<unsigned long long>(r.audit.checked - r.audit.failed),
                    static_cast<unsigned long long>(r.audit.checked), r.seconds.construction);
    }
    for (const Run_record& a : c.runs)
        for (const Run_record& b : c.runs)
            if (&a != &b && b.seconds.triangulation > 0 && a.seconds.triangulation >= b.seconds.triangulation)
                std::printf("%s/%s %.2f of the sums, %.2f of the medians\n", a.strategy.c_str(), b.strategy.c_str(),
                            a.seconds.triangulation / b.seconds.triangulation,
                            median_step(b) > 0 ? median_step(a) / median_step(b) : 0);
    print_input(c.runs[0].input, c.runs[0].dimension);
    if (c.agree) std::printf("all strategies agree\n");
    for (const std::string& line : c.disagreements) std::printf("DISAGREE: %s\n", line.c_str());
}

}  // namespace annulus::inline v1::cli
