// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/arguments.h>
#include <annulus/cli/input.h>
#include <annulus/motion/lloyd_2.h>
#include <annulus/motion/stippling.h>
#include <annulus/moving_mesh.h>

#include <optional>
#include <string>
#include <vector>

namespace annulus::cli {

/// The arguments that say which Lloyd iterations to run.
struct Lloyd_arguments {
    std::uint64_t points = 0;
    std::string input;
    bool ignore_z = false;
    std::string format;  ///< of the input, where not as its extension says
    bool open = false;   ///< its periodic box is ignored
    std::string density = "one";
    bool invert = false;
    std::string dots = "equal";
    std::string domain;
    double radius = 0;
    std::uint64_t iterations = 100;
};

void add_lloyd(CLI::App& app, Lloyd_arguments& arguments);

/// Points, domain and density of Lloyd iterations, checked.
struct Lloyd_scene {
    Domain_2 domain;
    Density_2 density;
    std::vector<Coordinates<2>> points;    ///< distinct, in the domain
    std::uint64_t merged = 0;              ///< duplicates of the input that were merged
    Input_record input{};                  ///< what was made of the input
    std::optional<Stippling> stippling{};  ///< where the density is a picture
    /// Mean spacing: the square root of area per point, the unit of length of the paper's figures.
    [[nodiscard]] double spacing() const;
};

/// Throws Input_error or Error.
[[nodiscard]] Lloyd_scene make_scene(const Lloyd_arguments& arguments, std::uint64_t seed);

/// The picture's dots, where Lloyd iterations left them, as an SVG document. Throws as `make_scene`.
[[nodiscard]] std::string stipples_of(const Lloyd_arguments& arguments, const Lloyd_scene& scene,
                                      const Moving_mesh_2& dt);

/// The stars of a triangulation, which costs what has changed.
void read_stars(const Moving_mesh_2& dt, Stars_2& stars);

}  // namespace annulus::cli
