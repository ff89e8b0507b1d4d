// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/arguments.h>
#include <apps/motion/domain_3.h>
#include <apps/motion/feature_curves.h>
#include <apps/motion/nodt_3.h>
#include <apps/motion/sizing_3.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace annulus::inline v1::cli {

/// The arguments that say which mesh to optimise.
struct Nodt_arguments {
    std::string surface;
    std::string mesh;
    bool allow_crossing = false;
    bool sphere = false;
    std::uint64_t vertices = 0;
    std::uint64_t iterations = 100;
    std::string sizing = "constant";
    std::optional<double> gradation;
    std::optional<double> lock;
    std::optional<double> sharp;
};

void add_nodt(CLI::App& app, Nodt_arguments& arguments);

/// Domain, sizing and initial vertices of an optimisation, checked.
struct Nodt_scene {
    std::unique_ptr<const Domain_3> domain;
    Sizing_3 sizing;
    std::vector<Coordinates<3>> points;
    std::vector<char> on_surface;                    ///< by vertex
    std::shared_ptr<const Feature_curves> features;  ///< sharp edges, if they are kept
    std::vector<std::string> notes;                  ///< remarks on the input for the pages
    /// Mean spacing: the cube root of the volume per vertex, the unit of length of the paper's figures.
    [[nodiscard]] double spacing() const;
    /// Throws Input_error if no cell is in the domain: then nothing would ever move.
    void require_cells(const Nodt_arguments& arguments, std::span<const char> inside) const;
    /// The motion that starts from this scene. It refers to the scene.
    [[nodiscard]] Nodt_3 motion(const Nodt_arguments& arguments, int threads) const;
};

/// Throws Input_error or Error.
[[nodiscard]] Nodt_scene make_scene(const Nodt_arguments& arguments, std::uint64_t seed);

}  // namespace annulus::inline v1::cli
