// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/frame_box.h>

#include <annulus/error.h>
#include <apps/formats/input_error.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1::cli {

bool is_periodic(const File_box& box, int d, const std::string& file) {
    std::string directions;
    int count = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(d); ++k) {
        if (!box.periodic[k]) continue;
        directions += (count++ > 0 ? std::string(" and ") : std::string()) + "xyz"[k];
    }
    if (count == d || count == 0) return count == d;
    throw Input_error(Error_code::bad_input, file, box.line,
                      box.what + ": a box that is periodic in " + directions + " only",
                      "one that is periodic in every direction, or --open, by which points are taken as they stand, "
                      "with open boundaries");
}

template <int d>
Box<d> box_of(const File_box& box, const std::string& file) {
    typename Box<d>::Vectors vectors{};
    for (std::size_t i = 0; i < d; ++i)
        for (std::size_t k = 0; k < 3; ++k) {
            if (k < d) vectors[i][k] = box.vectors[i][k];
            else if (box.vectors[i][k] != 0)
                throw Input_error(Error_code::bad_input, file, box.line, box.what + ": a vector of the box has a z",
                                  "--dim 3, or two vectors without one");
        }
    try {
        return Box<d>(vectors);
    } catch (const Error& error) {
        throw Input_error(Error_code::bad_input, file, box.line, box.what + ": " + error.what(),
                          "another box, or --open, by which points are taken as they stand, with open boundaries");
    }
}

int dimension_of_box(const std::vector<double>& numbers) {
    switch (numbers.size()) {
        case 2:
        case 4: return 2;
        case 3:
        case 9: return 3;
        default:
            throw Error(Error_code::usage, "--box has " + counted(numbers.size(), "number") +
                                               ", and a box has 2 or 4 in 2D, 3 or 9 in 3D");
    }
}

template <int d>
Box<d> box_of(const std::vector<double>& numbers) {
    typename Box<d>::Vectors vectors{};
    if (numbers.size() == d) {
        for (std::size_t i = 0; i < d; ++i) vectors[i][i] = numbers[i];
    } else if (numbers.size() == d * d) {
        for (std::size_t i = 0; i < numbers.size(); ++i) vectors[i / d][i % d] = numbers[i];
    } else {
        throw Error(Error_code::usage, "--box has " + counted(numbers.size(), "number") + ", and a box in " +
                                           std::to_string(d) + "D has " + std::to_string(d) + " lengths or " +
                                           std::to_string(d * d) + " coordinates of vectors");
    }
    try {
        return Box<d>(vectors);
    } catch (const Error& error) {
        throw Error(Error_code::usage, std::string("--box: ") + error.what());
    }
}

template <int d>
Input_error fault_in_box(const Error& error, const Point_file<d>& file, std::span<const Coordinates<d>> x) {
    const Coordinates<d>& p = x[static_cast<std::size_t>(error.vertices().back())];
    const auto& all = file.points;
    const auto at = static_cast<std::size_t>(std::find(all.begin(), all.end(), p) - all.begin());
    const bool duplicate = error.code() == Error_code::duplicate_point;
    return file.fault(at, error.code(),
                      duplicate ? "the point is at the place of another in the periodic box" : error.what(),
                      duplicate ? "points that differ" : "a point nearer to the box");
}

template <int d>
Frame_boxes<d>::Frame_boxes(bool periodic, const std::string& given) : periodic_(periodic) {
    if (given.empty()) return;
    what_ = "--box";
    now_ = box_of<d>(parse_box(given));
}

template <int d>
void Frame_boxes<d>::take(const Frame& frame, const std::string& file) {
    if (what_ == "--box") return;
    const bool has_box = frame.box && is_periodic(*frame.box, d, file);
    if (has_box != periodic_ && !frame.id.empty())
        throw Input_error(Error_code::bad_input, file, frame.box ? frame.box->line : frame.line.front(),
                          "a frame has " + std::string(has_box ? "a" : "no") +
                              " periodic box, and frames before have " + (has_box ? "none" : "one"),
                          "the same in every frame, --box, or --open");
    if (!has_box || !periodic_) return;
    what_ = frame.box->what;
    now_ = box_of<d>(*frame.box, file);
}

template class Frame_boxes<2>;
template class Frame_boxes<3>;
template Box<2> box_of<2>(const File_box&, const std::string&);
template Box<3> box_of<3>(const File_box&, const std::string&);
template Input_error fault_in_box<2>(const Error&, const Point_file<2>&, std::span<const Coordinates<2>>);
template Input_error fault_in_box<3>(const Error&, const Point_file<3>&, std::span<const Coordinates<3>>);
template Box<2> box_of<2>(const std::vector<double>&);
template Box<3> box_of<3>(const std::vector<double>&);

}  // namespace annulus::inline v1::cli
