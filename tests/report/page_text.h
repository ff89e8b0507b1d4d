// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A picture, a run, and what a page says.
#include <apps/report/report.h>

#include <cstddef>
#include <string>
#include <vector>

namespace annulus_test {

using namespace annulus;

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

inline std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t count = 0;
    for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++count;
    return count;
}

/// n by n points of a grid with the edges between neighbours.
inline Picture grid(Index n) {
    Picture picture;
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < n; ++j) {
            picture.points.push_back({static_cast<double>(i), static_cast<double>(j)});
            if (i > 0) picture.edges.push_back({n * i + j, n * (i - 1) + j});
            if (j > 0) picture.edges.push_back({n * i + j, n * i + j - 1});
        }
    return picture;
}

/// A run of two steps.
inline Run_record two_steps() {
    Run_record run;
    run.strategy = "auto";
    run.vertices = 100;
    run.iterations = 2;
    run.moves = {.asked = 200, .within_tolerance = 150};
    run.steps.resize(2);
    run.steps[0].iteration = 1;
    run.steps[1].iteration = 2;
    run.steps[0].displacement_mean = 0.5;
    run.steps[0].displacement_max = 2;
    run.steps[1].displacement_mean = 0.25;
    run.steps[1].displacement_max = 1;
    run.steps[0].flips = 3;
    run.steps[0].tested_tolerances = run.steps[1].tested_tolerances = true;
    run.steps[0].moves = {.asked = 100, .within_tolerance = 60};
    run.steps[1].moves = {.asked = 100, .within_tolerance = 90};
    return run;
}

inline std::string joined(const std::vector<std::string>& lines) {
    std::string all;
    for (const std::string& line : lines) all += line + "\n";
    return all;
}

}  // namespace annulus_test
