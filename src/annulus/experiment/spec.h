// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/experiment/trial.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace annulus {

/// A sweep as it is specified, in TOML (docs/formats.md): grids of experiments, each the product of its lists.
struct Spec {
    std::string title;
    std::uint64_t seed = 1;     ///< of all that is drawn
    std::size_t hardest = 0;    ///< inputs to keep of each certificate and stage
    std::vector<Trial> trials;  ///< of all grids, in their order: the last list of a grid changes fastest
    std::uint32_t identity =
        0;  ///< of the text, the title and the files that it names: what is equal has equal results

    static constexpr std::size_t most_trials = 1'000'000;
    static constexpr std::uint64_t most_points = 100'000'000;
    static constexpr std::uint64_t most_steps = 1'000'000'000;
    static constexpr std::size_t most_hardest = 100'000;
    static constexpr double most_pace = 1000;
};

/// Reads what `text` specifies; `name` is its file's, for messages, and files that it names are in `directory` unless
/// they are absolute.
/// Throws Input_error with the line of the value and its key for what is no TOML, an unknown key, a wrong type, a
/// value out of range, an empty list, what does not go together, and a file that cannot be read.
[[nodiscard]] Spec read_spec(const std::string& name, std::string_view text, const std::filesystem::path& directory);

/// The seed of one trial: of its place in the product, and of nothing else, so that it does not depend on the order
/// of lists or grids. Not of the rounding and the steps: the same points are rounded in all ways. Below 2^53, for
/// readers of JSON.
[[nodiscard]] std::uint64_t seed_of(std::uint64_t spec_seed, const Trial& trial, std::uint64_t repetition);

}  // namespace annulus
