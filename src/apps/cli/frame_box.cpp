// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/frame_box.h>

#include <annulus/error.h>
#include <apps/formats/input_error.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1::cli {

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
template Input_error fault_in_box<2>(const Error&, const Point_file<2>&, std::span<const Coordinates<2>>);
template Input_error fault_in_box<3>(const Error&, const Point_file<3>&, std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1::cli
