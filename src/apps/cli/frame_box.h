// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <apps/formats/given_box.h>
#include <apps/formats/number_list.h>
#include <apps/motion/recorded_motion.h>

#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1::cli {

/// The numbers of --box: d lengths, or d vectors one after the other, separated by commas. Throws Error(usage).
[[nodiscard]] inline std::vector<double> parse_box(const std::string& words) { return parse_numbers("--box", words); }

/// The boxes of the frames of a periodic motion, one after the other.
template <int d>
class Frame_boxes {
  public:
    /// Of a motion with open boundaries, unless `periodic`; then all frames are in the box of --box, unless it is
    /// empty.
    Frame_boxes(bool periodic, const std::string& given);

    /// Takes the box of the next frame. Throws Input_error where a frame has one and another frame does not.
    void take(const Frame& frame, const std::string& file);
    [[nodiscard]] bool periodic() const { return periodic_; }
    /// Of the last frame that has points, or has a box. Precondition: the motion is periodic.
    [[nodiscard]] const Box<d>& now() const { return *now_; }
    /// Where it comes from: "--box", "Lattice".
    [[nodiscard]] const std::string& what() const { return what_; }

  private:
    bool periodic_;
    std::string what_;
    std::optional<Box<d>> now_;
};

extern template class Frame_boxes<2>;
extern template class Frame_boxes<3>;

}  // namespace annulus::inline v1::cli
