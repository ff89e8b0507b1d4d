// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/svg_plot.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

struct Tick {
    double value = 0;
    std::string label;  ///< empty for a minor tick
};

/// The range and the ticks of one axis.
class Axis_range {
  public:
    /// Covers the values that the axis can show, widened to whole steps (linear) or by a margin (logarithmic). Two
    /// ticks or more have labels, except where the given ends of a logarithmic axis are nearly equal.
    Axis_range(const Axis& axis, const std::vector<double>& values);

    /// Position of a value, 0 at the lower end and 1 at the upper.
    [[nodiscard]] double place(double value) const;
    /// False for a value that the scale cannot show: not finite, not positive on a logarithmic axis, beyond 1e290 or
    /// 1e-290.
    [[nodiscard]] bool can_show(double value) const;
    [[nodiscard]] const std::vector<Tick>& ticks() const noexcept { return ticks_; }
    [[nodiscard]] double lower() const noexcept { return lower_; }
    [[nodiscard]] double upper() const noexcept { return upper_; }

  private:
    void make_linear(const Axis& axis);
    void make_logarithmic();

    Scale scale_;
    double lower_ = 0;
    double upper_ = 1;
    std::vector<Tick> ticks_;
};

/// A number for display: three significant digits, thousands grouped (12,300), powers of ten written out when far from
/// 1.
[[nodiscard]] std::string readable(double value);

/// An integer with its thousands grouped: 1,234,567.
[[nodiscard]] std::string grouped(std::uint64_t value);
/// "1,234 frames", "1 frame".
[[nodiscard]] std::string grouped(std::uint64_t value, std::string_view noun);
/// "none", or the number, grouped.
[[nodiscard]] std::string none_or(std::uint64_t value);

}  // namespace annulus::inline v1
