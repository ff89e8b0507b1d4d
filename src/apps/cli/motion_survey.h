// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/degeneracy.h>
#include <apps/formats/frame_points.h>
#include <apps/formats/point_ids.h>
#include <apps/report/advice_record.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace annulus::inline v1::cli {

/// Lengths, in mean spacings, by a histogram of logarithms: memory does not depend on their number.
class Length_counts {
  public:
    void add(double length);
    void add(const Length_counts& other);
    /// Precondition: there is a length.
    [[nodiscard]] Displacement_record record() const;

  private:
    Histogram histogram_ = Histogram::log10(1e-15, 1e6, 21 * 120);  // two percent a bin
    std::vector<std::uint64_t> counts_;                             // of other histograms with the same bins
    std::uint64_t total_ = 0, at_rest_ = 0, below_ = 0;             // below_: less than all bins
    double sum_ = 0, max_ = 0;
};

/// Looks at the frames of a motion, one after another: displacements, duplicates, points that come and go, jumps by
/// about the length of a box. Memory is linear in the number of points of a frame.
template <int d>
class Motion_survey {
  public:
    /// `frame` is what points_of made of `as_read`, with Coincident::merge. O(n), and O(n log n) where points
    /// coincide.
    void add(const Frame& as_read, const Frame_points<d>& frame, const Point_ids& ids);
    /// Of all frames so far. Precondition: there is one.
    [[nodiscard]] Motion_record record() const;

  private:
    void start(const Frame_points<d>& frame);
    void count_duplicates(const Frame& as_read, const Point_ids& ids);
    void count_changes(const Frame_points<d>& frame, const Point_ids& ids);
    /// Which axis has a jump, if any: d where none has.
    [[nodiscard]] std::size_t axis_of_jump(const Coordinates<d>& from, const Coordinates<d>& to);

    Motion_record record_;
    Coordinates<d> side_{};  // of the box of the first frame with points
    Frame_points<d> last_;
    Length_counts steady_, jumping_;
    std::uint64_t half_jumps_ = 0;  // coordinates that change by a quarter to three quarters of a side
};

extern template class Motion_survey<2>;
extern template class Motion_survey<3>;

}  // namespace annulus::inline v1::cli
