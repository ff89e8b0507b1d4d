// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/point_formats.h>

#include <cstdint>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The faces of one file, unchecked: polygons of any number of corners, which may name points that do not exist.
struct Raw_faces {
    std::vector<std::uint64_t> corners;  ///< of all faces, one after the other; from 0
    std::vector<std::size_t> ends{0};    ///< face i has the corners ends[i] to ends[i + 1]
    std::vector<std::uint64_t> lines;    ///< of each face: line, or record in a binary file, from 1

    [[nodiscard]] std::size_t size() const { return lines.size(); }
    [[nodiscard]] std::span<const std::uint64_t> of(std::size_t i) const {
        return {corners.data() + ends[i], ends[i + 1] - ends[i]};
    }
    void close(std::uint64_t line) {
        ends.push_back(corners.size());
        lines.push_back(line);
    }
};

/// `v x y z` and `f a b c ...` of Wavefront OBJ; texture and normal indices, and all other lines, are skipped.
[[nodiscard]] Raw_points read_obj(const Source& source, Raw_faces& faces);

/// Three points for every triangle of an STL file, ASCII or binary.
[[nodiscard]] Raw_points read_stl(const Source& source, Raw_faces& faces);

}  // namespace annulus::inline v1
