// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <apps/formats/point_ids.h>
#include <apps/motion/recorded_motion.h>

#include <cstdint>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// How to treat points at the same position, or in a periodic box at the same place of it, in one frame.
enum class Coincident {
    refuse,  ///< an Input_error(duplicate_point)
    merge,   ///< keep the one with the least id; the others are absent from this frame
};

/// Points of one frame that a triangulation accepts: none outside the domain of the library, no two equal, no -0.
template <int d>
struct Frame_points {
    std::uint64_t number = 0;         ///< the frame's number in the file
    std::vector<std::uint64_t> id{};  ///< ascending
    std::vector<Coordinates<d>> x{};
    std::uint64_t merged = 0;  ///< points that were dropped in favour of another one
};

/// Drops z in two dimensions. Throws Input_error with the name of the file, and with ids as they are in the file.
/// O(n log n).
template <int d>
[[nodiscard]] Frame_points<d> points_of(const std::string& name, const Frame& frame, Coincident coincident,
                                        const Point_ids& ids);
/// The same for ids that are integers of 0 or more.
template <int d>
[[nodiscard]] Frame_points<d> points_of(const std::string& name, const Frame& frame, Coincident coincident) {
    return points_of<d>(name, frame, coincident, Point_ids());
}

/// Merges points of which one is an image of another, rounded to the grid of the box, as Coincident::merge does those
/// at one position. Throws Error for a point more than 2^29 boxes away, which it names; then nothing has changed.
/// O(n log n).
template <int d>
void merge_images(Frame_points<d>& points, const Box<d>& box);

extern template void merge_images(Frame_points<2>&, const Box<2>&);
extern template void merge_images(Frame_points<3>&, const Box<3>&);
extern template Frame_points<2> points_of<2>(const std::string&, const Frame&, Coincident, const Point_ids&);
extern template Frame_points<3> points_of<3>(const std::string&, const Frame&, Coincident, const Point_ids&);

}  // namespace annulus::inline v1
