// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the tests with the seed of tests/seed for Catch and RapidCheck, printed first, and at the same addresses: the
// same cases every time. ANNULUS_TEST_SEED is another one (tools/explore); `--rng-seed` and a `seed=` in RC_PARAMS go
// before both. ANNULUS_TEST_MULTIPLIER multiplies the length of every property and every loop over repeats(n); a
// `max_success=` in RC_PARAMS has precedence.
#define CATCH_CONFIG_RUNNER
#include <support/catch.h>
#include <support/repeats.h>
#include <support/same_addresses.h>
#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <iostream>
#include <string>

namespace {

constexpr std::uint32_t fixed_seed =
#include "seed"
    ;

std::string environment(const char* name) {
    const char* value = std::getenv(name);
    return value ? value : "";
}

std::uint32_t seed_of_this_run() {
    const std::string given = environment("ANNULUS_TEST_SEED");
    if (!given.empty()) return static_cast<std::uint32_t>(std::stoul(given));
    return fixed_seed;  // not 0, which Catch takes for "no seed"
}

// RapidCheck reads RC_PARAMS once, at the first property.
void give_rapidcheck_its_parameters(std::uint32_t seed) {
    std::string parameters = environment("RC_PARAMS");
    const auto add = [&parameters](const std::string& name, const std::string& value) {
        if (parameters.find(name) == std::string::npos) parameters += (parameters.empty() ? name : " " + name) + value;
    };
    add("seed=", std::to_string(seed));
    add("max_success=", std::to_string(annulus::repeats(100)));
    setenv("RC_PARAMS", parameters.c_str(), 1);
}

}  // namespace

int main(int argc, char* argv[]) {
    annulus::testing::same_addresses_every_time(argv);
    const std::uint32_t seed = seed_of_this_run();
    Catch::Session session;
    session.configData().rngSeed = seed;
    const int usage_error = session.applyCommandLine(argc, argv);
    if (usage_error != 0) return usage_error;

    const Catch::ConfigData& config = session.configData();
#if CATCH_VERSION_MAJOR >= 3
    const bool lists = config.listTests || config.listTags || config.listReporters || config.listListeners;
#else
    const bool lists = config.listTests || config.listTags || config.listReporters || config.listTestNamesOnly;
#endif
    if (!lists && !config.showHelp && !config.libIdentify) {
        give_rapidcheck_its_parameters(seed);
        std::cout << "seeds: ANNULUS_TEST_SEED=" << seed << " (--rng-seed " << config.rngSeed << ", RC_PARAMS=\""
                  << environment("RC_PARAMS") << "\")" << std::endl;
    }
    return std::min(session.run(), 255);  // a list returns its length, and an exit status is eight bits
}
