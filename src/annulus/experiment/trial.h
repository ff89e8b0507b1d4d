// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/experiment/hard_inputs.h>
#include <annulus/experiment/rounding.h>
#include <annulus/motion/generated_motion.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus {

/// Where points go from where they were generated.
struct Trial_motion {
    enum class Kind : std::uint8_t { generated, lloyd, nodt };
    std::string name;
    Kind kind = Kind::generated;
    Motion_family family = Motion_family::walk;  ///< of a generated one
    double pace = 0;                             ///< of a generated one, in spacings (Generated_motion)
};

/// What is computed at one go: points, from a generator or a file, and their motion, looked at after some of its
/// steps. Each look is an experiment, one line of results.
struct Trial {
    std::size_t grid = 0;  ///< of the specification, from 0
    std::string grid_name{};
    int dimension = 2;    ///< of a file 0: that of the file
    Rounding rounding{};  ///< of what is looked at; a motion goes on in doubles

    std::string kind{};  ///< of generated points
    Point_family family = Point_family::uniform;
    std::uint64_t points = 0;
    std::uint64_t seed = 0;  ///< of points and motion, as in `annulus generate`
    std::optional<Trial_motion> motion{};
    std::vector<std::uint64_t> steps{0};  ///< ascending

    std::string file{};                   ///< recorded points: as the specification names it
    std::string path{};                   ///< where that is
    std::vector<std::uint64_t> frames{};  ///< of a recorded motion; none with `every`, or where it is a point set
    std::uint64_t every = 0;
    bool open = false;  ///< a periodic box of the file is ignored

    /// What it takes, roughly: to plan with, nothing depends on it.
    double seconds = 0;
    std::uint64_t bytes = 0;
};

/// What came of a trial.
struct Trial_result {
    explicit Trial_result(std::size_t hardest) : hard(hardest) {}
    /// JSON, one for each experiment, in the order of steps or frames; without line ends.
    std::vector<std::string> lines{};
    Hard_inputs hard;
    double seconds = 0;            ///< it took
    std::uint64_t peak_bytes = 0;  ///< that this process had resident at most until then; 0 when unknown
};

/// Runs one: what it finds depends on the trial alone, and not on `threads`, which work on Lloyd's iteration, natural
/// ODT and certificates. `hardest` inputs are kept for each certificate and stage. Throws Input_error for a file that
/// is not as it should be, Error.
[[nodiscard]] Trial_result run(const Trial& trial, std::size_t hardest, int threads = 1);

/// Sets `seconds` and `bytes` of a trial of that many points.
void estimate(Trial& trial, std::uint64_t points, int dimension);

}  // namespace annulus
