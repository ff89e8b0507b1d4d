// SPDX-License-Identifier: GPL-3.0-or-later
// Five points in 3D for which the paper's tolerance is too large (docs/theory.md 3).
#include <annulus/error.h>
#include <apps/cli/arguments.h>
#include <apps/cli/commands.h>
#include <apps/cli/result_files.h>
#include <apps/formats/write_json.h>
#include <apps/report/counterexample_json.h>

#include <cmath>
#include <cstdio>
#include <memory>

namespace annulus::inline v1::cli {

namespace {

void print(const Counterexample& r) {
    const auto word = [](bool yes) { return yes ? "Delaunay" : "NOT Delaunay"; };
    const auto accepts = [](bool yes) { return yes ? "accepts" : "requires an evaluation"; };
    std::printf("five points    a, b = (0, 0, +-%.17g), p, q, r at 120 degrees on the unit circle of z = 0\n",
                1.0 - r.delta);
    std::printf("triangulation  three cells around ab: %s\n", word(r.three_before));
    std::printf("tolerance      paper %.17g (standard annulus)\n", r.paper);
    std::printf("               certified %.17g (%s stage)\n", r.certified.tolerance,
                std::string(name_of(r.certified.stage)).c_str());
    std::printf("               exact %.17g, the largest double not above it\n", r.exact);
    std::printf("theta          %.17g, the least of the three facets at ab\n", r.theta);
    std::printf("move           a, b outward and p, q, r inward by %.17g\n", r.move);
    std::printf("               paper %s, certified %s\n", accepts(r.displaced < r.paper),
                accepts(r.displaced < r.certified.tolerance));
    std::printf("triangulation  three cells around ab: %s; two cells at pqr: %s\n", word(r.three_after),
                word(r.two_after));
}

}  // namespace

Run add_counterexample_command(CLI::App& app, const Invocation& invocation) {
    struct Arguments {
        Common_arguments common;
        double delta = 0.01;
        bool json = false;
    };
    auto* sub = app.add_subcommand(
        "counterexample",
        "Five points in 3D where the paper's tolerance accepts a triangulation that is no longer Delaunay");
    const auto a = std::make_shared<Arguments>();
    sub->add_option("--delta", a->delta, "How far a and b are inside the unit sphere, 2^-40 to 0.1")
        ->check(number_within(0x1p-40, 0.1))
        ->capture_default_str();
    sub->add_flag("--json", a->json, "Print JSON instead of text");
    add_common(*sub, a->common, "counterexample.json", {no_seed, no_threads});
    return [a, command = command_line(invocation.words)] {
        if (std::isnan(a->delta)) throw Error(Error_code::usage, "--delta: not a number");
        const Counterexample r = counterexample(a->delta);
        const std::string text = write_json(counterexample_json(r, command));
        if (!a->common.output.empty()) {
            Result_files out(a->common, [](std::string_view name) { return name == "counterexample.json"; });
            out.write("counterexample.json", text);
            out.commit();
        }
        if (a->common.quiet) return done;
        if (a->json) std::printf("%s", text.c_str());
        else print(r);
        return done;
    };
}

}  // namespace annulus::inline v1::cli
