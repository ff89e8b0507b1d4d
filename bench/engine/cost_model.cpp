// SPDX-License-Identifier: GPL-3.0-or-later
// Measures the costs of engine/cost_model.h on this machine, in cells tested. Every repetition measures each cost once,
// with another seed, and divides it by the time of testing a cell in the same repetition (bench/calibrate makes a table
// of the results).
#include "cost_repetition.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <cstdio>
#include <exception>

namespace {

using bench::Repetition;
using nlohmann::ordered_json;

template <int d>
ordered_json run(std::size_t n, int repeat) {
    ordered_json all;
    for (int k = 1; k <= repeat; ++k) {
        const ordered_json one = Repetition<d>(n, static_cast<std::uint64_t>(k)).measure();
        for (const auto& [name, value] : one.items()) all[name].push_back(value);
    }
    return all;
}

}  // namespace

int main(int argc, char** argv) {
    int repeat = 5;
    CLI::App app{"The costs of engine/cost_model.h on this machine, in cells tested."};
    app.add_option("--repeat", repeat)->check(CLI::Range(1, 1000));
    CLI11_PARSE(app, argc, argv);
    try {
        const ordered_json out{{"2", run<2>(10000, repeat)}, {"3", run<3>(8000, repeat)}};
        std::printf("%s\n", out.dump().c_str());
    } catch (const std::exception& e) {
        std::fprintf(stderr, "annulus-cost-model: %s\n", e.what());
        return 3;
    }
}
