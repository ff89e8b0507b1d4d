// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/moving_mesh.h>
#include <apps/cli/arguments.h>
#include <apps/cli/input.h>
#include <apps/motion/lloyd_2.h>
#include <apps/motion/stippling.h>
#include <apps/report/report.h>

#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1::cli {

/// The arguments that say which Lloyd iterations to run.
struct Lloyd_arguments {
    std::uint64_t points = 0;
    std::string input;
    bool ignore_z = false;
    std::string format;  ///< of the input, if not that of its extension
    bool open = false;   ///< ignore the periodic box of the input
    std::string density = "one";
    bool invert = false;
    std::string dots = "equal";
    std::string domain;
    double radius = 0;
    std::string size{};  ///< of --domain box
    bool keep_boundary = false;
    std::uint64_t iterations = 100;
};

void add_lloyd(CLI::App& app, Lloyd_arguments& arguments);

/// Points, domain and density of Lloyd iterations, checked.
struct Lloyd_scene {
    Region_2 domain;
    Density_2 density;
    std::vector<Coordinates<2>> points;    ///< distinct, in the domain
    std::uint64_t merged = 0;              ///< duplicate points of the input that were merged
    Input_record input{};                  ///< how the input was interpreted
    std::optional<Stippling> stippling{};  ///< if the density is a picture
    Kept_border_2 border{};                ///< vertices that stay on the border
    /// Mean spacing: the square root of the area per point, the unit of length of the paper's figures.
    [[nodiscard]] double spacing() const;
};

/// Throws Input_error or Error.
[[nodiscard]] Lloyd_scene make_scene(const Lloyd_arguments& arguments, std::uint64_t seed);

/// The dots of the picture at the final positions of the points, as an SVG document. Throws as `make_scene`.
[[nodiscard]] std::string stipples_of(const Lloyd_arguments& arguments, const Lloyd_scene& scene,
                                      const Moving_mesh_2& dt);

/// The picture beside these dots, for the page; of more than 20,000 dots only the picture.
[[nodiscard]] std::vector<Drawing> drawings_of(const Lloyd_scene& scene, const std::string& stipples);

/// Reads the stars of a triangulation. The cost depends on what has changed since the last call.
void read_stars(const Moving_mesh_2& dt, Stars_2& stars);

}  // namespace annulus::inline v1::cli
