// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/experiment/hard_inputs.h>
#include <apps/experiment/rounding.h>
#include <apps/motion/crystal.h>
#include <apps/motion/generated_motion.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// How generated points move.
struct Trial_motion {
    enum class Kind : std::uint8_t { generated, lloyd, nodt };
    std::string name;
    Kind kind = Kind::generated;
    Motion_family family = Motion_family::walk;  ///< of a generated one
    double pace = 0;                             ///< of a generated one, in spacings (Generated_motion)
};

/// A unit of work: points, from a generator or a file, and their motion, examined after some of its steps. Each
/// examination is an experiment, one line of results.
struct Trial {
    std::size_t grid = 0;  ///< of the specification, from 0
    std::string grid_name{};
    int dimension = 2;    ///< 0 for a file: that of the file
    Rounding rounding{};  ///< of the examined points; a motion continues in doubles

    /// The numbers of a periodic box (formats/given_box.h), for a file in place of its own. None: boundaries are open,
    /// or the file decides.
    std::vector<double> box{};

    std::string kind{};  ///< of generated points
    Point_family family = Point_family::uniform;
    std::optional<Crystal> crystal{};  ///< in place of the family, in a box
    std::uint64_t points = 0;
    std::uint64_t seed = 0;  ///< of points and motion, as in `annulus generate`
    std::optional<Trial_motion> motion{};
    std::vector<std::uint64_t> steps{0};  ///< ascending

    std::string file{};                   ///< recorded points: its name in the specification
    std::string path{};                   ///< its path
    std::vector<std::uint64_t> frames{};  ///< of a recorded motion; none with `every`, or for a point set
    std::uint64_t every = 0;
    bool open = false;  ///< whether a periodic box of the file is ignored

    /// Estimated cost, for planning only: no result depends on it.
    double seconds = 0;
    std::uint64_t bytes = 0;
};

/// The result of a trial.
struct Trial_result {
    explicit Trial_result(std::size_t hardest) : hard(hardest) {}
    /// JSON, one for each experiment, in the order of steps or frames; without line ends.
    std::vector<std::string> lines{};
    Hard_inputs hard;
    double seconds = 0;            ///< elapsed time
    std::uint64_t peak_bytes = 0;  ///< peak of this process' resident memory until then; 0 when unknown
};

/// Runs one trial. Its results depend on the trial alone, and not on `threads`, the number that work on Lloyd's
/// iteration, natural ODT and certificates. Keeps `hardest` inputs for each certificate and stage. Throws Input_error
/// for an invalid file, Error.
[[nodiscard]] Trial_result run(const Trial& trial, std::size_t hardest, int threads = 1);

/// Sets `seconds` and `bytes` of a trial with this many points.
void estimate(Trial& trial, std::uint64_t points, int dimension);

}  // namespace annulus::inline v1
