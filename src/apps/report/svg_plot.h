// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/degeneracy.h>

#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

enum class Scale { linear, log10 };

struct Axis {
    std::string label;  ///< with its unit, as in "mean displacement (mean spacings)"
    Scale scale = Scale::linear;
    /// The range to show; where absent, that of the data.
    std::optional<double> lower = std::nullopt;
    std::optional<double> upper = std::nullopt;
    bool tight = false;  ///< on a logarithmic axis: no margin around the data
};

/// A curve. Points that are not finite, or not positive on a logarithmic axis, interrupt it.
struct Series {
    std::string name;  ///< written at the end of the curve
    std::vector<double> x;
    std::vector<double> y;
    bool steps = false;  ///< a histogram: x are the bin edges, one more than y
    /// By point, the length of its error bar to either side; no bar where it is not positive, or missing.
    std::vector<double> error{};
};

struct Plot {
    std::string title;
    Axis x;
    Axis y;
    std::vector<Series> series;
};

/// The outline of a histogram from its first bin with samples to its last and an empty one before and after them, as
/// shares of all samples in percent.
[[nodiscard]] Series histogram_series(std::string name, const Histogram& histogram);

/// The plot as one SVG element, 520 by 360 units, that scales with its container. Colours and fonts come from CSS
/// classes (see report_style.h), so that the page chooses light or dark. Up to 14 curves differ by colour or by dashes,
/// all by the names at their ends. Many points are thinned to the resolution of a pixel. All text is escaped. Linear in
/// the points.
[[nodiscard]] std::string svg_plot(const Plot& plot);

}  // namespace annulus::inline v1
