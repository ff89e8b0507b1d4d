// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/experiment/trial.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// The specification of a sweep, in TOML (docs/formats.md): grids of experiments, each the product of its lists.
struct Spec {
    std::string title;
    std::uint64_t seed = 1;     ///< of all random numbers
    std::size_t hardest = 0;    ///< number of inputs to keep for each certificate and stage
    std::vector<Trial> trials;  ///< of all grids, in their order: the last list of a grid changes fastest
    std::uint32_t identity =
        0;  ///< of the text, the title and the files that it names: equal identities have equal results

    static constexpr std::size_t most_trials = 1'000'000;
    static constexpr std::uint64_t most_points = 100'000'000;
    static constexpr std::uint64_t most_steps = 1'000'000'000;
    static constexpr std::size_t most_hardest = 100'000;
    static constexpr double most_pace = 1000;
};

/// Parses `text`; `name` is the name of its file, for messages. Files that it names are relative to `directory` unless
/// absolute. Throws Input_error with the line of the value and its key for invalid TOML, an unknown key, a wrong type,
/// a value out of range, an empty list, keys that exclude each other, and a file that cannot be read.
[[nodiscard]] Spec read_spec(const std::string& name, std::string_view text, const std::filesystem::path& directory);

/// The seed of one trial, a function only of its values in the product, so that it does not depend on the order of
/// lists or grids. It does not depend on the rounding and the steps either: the same points are rounded in all ways.
/// Below 2^53, for readers of JSON.
[[nodiscard]] std::uint64_t seed_of(std::uint64_t spec_seed, const Trial& trial, std::uint64_t repetition);

}  // namespace annulus::inline v1
