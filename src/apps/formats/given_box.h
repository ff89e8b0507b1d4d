// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <apps/motion/file_box.h>

#include <string>
#include <vector>

namespace annulus::inline v1 {

/// Whether a box of a file is periodic in the first d directions. Throws Input_error where it is in some of them only;
/// `open` is what ignores the box, for the error.
[[nodiscard]] bool is_periodic(const File_box& box, int d, const std::string& file, const std::string& open = "--open");

/// The box of its first d vectors. Throws Input_error where Box refuses them, and in 2D where one of the two has a z.
template <int d>
[[nodiscard]] Box<d> box_of(const File_box& box, const std::string& file, const std::string& open = "--open");

/// Of the numbers of an option, d lengths, or d vectors one after the other: 2 for 2 or 4 numbers, 3 for 3 or 9.
/// Throws Error(usage).
[[nodiscard]] int dimension_of_box(const std::vector<double>& numbers, const std::string& option = "--box");
/// Their box. Throws Error(usage).
template <int d>
[[nodiscard]] Box<d> box_of(const std::vector<double>& numbers, const std::string& option = "--box");

extern template Box<2> box_of<2>(const File_box&, const std::string&, const std::string&);
extern template Box<3> box_of<3>(const File_box&, const std::string&, const std::string&);
extern template Box<2> box_of<2>(const std::vector<double>&, const std::string&);
extern template Box<3> box_of<3>(const std::vector<double>&, const std::string&);

}  // namespace annulus::inline v1
