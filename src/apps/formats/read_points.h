// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/types.h>
#include <apps/formats/input_error.h>
#include <apps/formats/periodic_box.h>
#include <apps/formats/table_columns.h>
#include <apps/formats/taken_columns.h>
#include <apps/motion/file_box.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace annulus::inline v1 {

struct Read_options {
    /// In two dimensions, drop a z coordinate instead of refusing the file.
    bool ignore_z = false;
    /// "xyz", "csv" ..: the format of the file in place of that of its extension; standard input has none.
    std::string format{};
    Periodic_box box{};
    Column_choice columns{};  ///< which columns of a table are taken; the others are found by their names
};

/// The points of one file, in its order and in its unit of length. All coordinates are finite.
template <int d>
struct Point_file {
    std::string name;
    std::vector<Coordinates<d>> points;
    /// Of each point: its line, or the number of its record in a binary file, from 1.
    std::vector<std::uint64_t> lines;
    Taken_columns columns;  ///< which columns were taken
    /// Content of the file that is ignored or may have another meaning; each a line with the file's name.
    std::vector<std::string> notes;
    bool ignored_box = false;       ///< whether a periodic box was ignored
    std::optional<File_box> box{};  ///< a box that is periodic in some direction, where boxes are taken

    /// A fault found later in point i (a duplicate, a point outside the domain), reported like the reader's own.
    [[nodiscard]] Input_error fault(std::size_t i, Error_code code, std::string what, std::string expected) const {
        return {code, name, lines.at(i), std::move(what), std::move(expected)};
    }
};

/// Reads points by the extension of the file: .xyz, .csv, .lammpstrj, .npy, .off, .ply, .mesh (either case; see
/// format.h), and .gz after it; see point_formats.h, frame_readers.h, csv_frames.h and npy_frames.h. `-` is standard
/// input. A file of several frames is refused, and one with a periodic box unless it is to be taken or ignored.
///
/// Decimals are rounded correctly. d is 2 or 3. Throws Input_error for every fault of the file, including a file
/// without points, a z coordinate when d is 2 (unless ignored), and none when d is 3. Linear in the size of the file,
/// which is held in memory.
template <int d>
[[nodiscard]] Point_file<d> read_points(const std::filesystem::path& file, const Read_options& options = {});

/// The same in the dimension of the file: 3 where its points have a z that is not ignored.
[[nodiscard]] std::variant<Point_file<2>, Point_file<3>> read_points_of_any_dimension(const std::filesystem::path& file,
                                                                                      const Read_options& options = {});

template <int d>
struct Distinct_points {
    std::vector<Coordinates<d>> x;     ///< no -0
    std::vector<std::uint64_t> index;  ///< of each in the file
};

/// The distinct points of a file in the order of their first occurrence; in a periodic box those that are, rounded to
/// its grid, images of one another are one. Throws Input_error for a point outside the domain of the library or too far
/// from the box, and for fewer than `at_least` distinct ones. O(n log n).
template <int d>
[[nodiscard]] Distinct_points<d> distinct_points(const Point_file<d>& file, std::size_t at_least,
                                                 const Box<d>* box = nullptr);

extern template Point_file<2> read_points<2>(const std::filesystem::path&, const Read_options&);
extern template Point_file<3> read_points<3>(const std::filesystem::path&, const Read_options&);
extern template Distinct_points<2> distinct_points<2>(const Point_file<2>&, std::size_t, const Box<2>*);
extern template Distinct_points<3> distinct_points<3>(const Point_file<3>&, std::size_t, const Box<3>*);

}  // namespace annulus::inline v1
