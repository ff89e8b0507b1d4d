// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/frame_box.h>

#include <apps/formats/input_error.h>

namespace annulus::inline v1::cli {

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

}  // namespace annulus::inline v1::cli
