// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/input_error.h>
#include <apps/motion/triangle_surface.h>

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// A closed triangle surface from a file.
///
/// Every edge is in two triangles, which run through it in opposite directions; the enclosed volume is positive; points
/// are finite, differ and are all used. Not checked: that the surface does not cross itself.
struct Surface_file {
    std::string name;
    Triangle_surface surface;
    std::uint64_t merged = 0;  ///< points that were equal to another one
};

/// Reads .off, .obj, .ply (ASCII, binary of either byte order) or .stl (ASCII, binary), by extension, either case.
///
/// Polygons are cut into triangles from their first corner. Equal points are merged, points without a triangle dropped,
/// a surface that is inside out is reversed. Throws Input_error for every fault of the file, including an edge that is
/// not in two triangles. O(n log n).
[[nodiscard]] Surface_file read_surface(const std::filesystem::path& file);

}  // namespace annulus::inline v1
