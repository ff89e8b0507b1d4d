// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// A picture, and what a page says.
#include <apps/report/report.h>

#include <cstddef>
#include <string>

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

}  // namespace annulus_test
