// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/svg_plot.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace annulus::inline v1 {

namespace {

constexpr double width = 520;
constexpr double height = 360;
constexpr double least_left = 58;  ///< room for the label of the y axis, and four digits
constexpr double top = 14;
constexpr double bottom = 52;
constexpr double line_height = 16;    ///< between the names of curves
constexpr double letter_width = 8.2;  ///< of bold text at 13 units in a wide font
constexpr double number_width = 9.4;  ///< of a digit at 15 units, as in narrow windows
constexpr std::size_t colours = 7;    ///< classes c0 to c6

/// The classes of the curve with this index: a colour, and from the eighth curve on other dashes.
std::string style(std::size_t index) {
    return "c" + std::to_string(index % colours) + (index / colours % 2 == 1 ? " again" : "");
}

std::string number(double value) {
    char text[400];  // room for any double; independent of the locale
    return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::fixed, 1).ptr};
}

/// The positions of the axes, in the units of the drawing.
struct Frame {
    double left = least_left;
    double right = width - 24;  ///< leaves half a tick label
    [[nodiscard]] double x(double place) const { return left + place * (right - left); }
    [[nodiscard]] double y(double place) const { return height - bottom - place * (height - bottom - top); }
};

struct Pixel {
    double x;
    double y;
};

/// The number of UTF-8 characters.
std::size_t letters(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) { return (c & 0xC0) != 0x80; }));
}

/// Names of curves are to the right of the frame, so it ends where the longest begins; it begins where the longest
/// number ends.
Frame frame_for(const Plot& plot, const Axis_range& ys) {
    std::size_t longest = 0;
    for (const Series& s : plot.series)
        if (!s.steps) longest = std::max(longest, letters(s.name));
    Frame frame;
    for (const Tick& tick : ys.ticks())
        frame.left = std::max(frame.left, 24 + number_width * static_cast<double>(letters(tick.label)));
    if (longest > 0) frame.right = width - std::min(letter_width * static_cast<double>(longest) + 14, 240.);
    return frame;
}

void draw_axes(std::string& out, const Plot& plot, const Frame& frame, const Axis_range& xs, const Axis_range& ys) {
    const std::string x0 = number(frame.x(0)), x1 = number(frame.x(1)), y0 = number(frame.y(0)),
                      y1 = number(frame.y(1));
    for (const Tick& tick : ys.ticks()) {
        const std::string y = number(frame.y(ys.place(tick.value)));
        if (tick.label.empty()) {
            out += "<path class=\"tick\" d=\"M" + x0 + " " + y + "h4\"/>";
            continue;
        }
        out += "<path class=\"grid\" d=\"M" + x0 + " " + y + "H" + x1 + "\"/>";
        out += "<text class=\"tl e\" x=\"" + number(frame.left - 7) + "\" y=\"" + y + "\" dy=\".34em\">" +
               escaped(tick.label) + "</text>";
    }
    for (const Tick& tick : xs.ticks()) {
        const std::string x = number(frame.x(xs.place(tick.value)));
        out += "<path class=\"tick\" d=\"M" + x + " " + y0 + (tick.label.empty() ? "v-4" : "v-6") + "\"/>";
        if (!tick.label.empty())
            out += "<text class=\"tl m\" x=\"" + x + "\" y=\"" + number(height - bottom + 18) + "\">" +
                   escaped(tick.label) + "</text>";
    }
    out += "<path class=\"axis\" d=\"M" + x0 + " " + y1 + "V" + y0 + "H" + x1 + "\"/>";
    out += "<text class=\"al m\" x=\"" + number((frame.x(0) + frame.x(1)) / 2) + "\" y=\"" + number(height - 12) +
           "\">" + escaped(plot.x.label) + "</text>";
    out += "<text class=\"al m\" transform=\"translate(14 " + number((frame.y(0) + frame.y(1)) / 2) +
           ")rotate(-90)\">" + escaped(plot.y.label) + "</text>";
}

/// Appends the piece of a curve between two interruptions, thinned: of all points within half a unit of x, the first,
/// lowest, highest and last give the same picture.
void draw_piece(std::string& path, const std::vector<Pixel>& piece) {
    for (std::size_t i = 0; i < piece.size();) {
        std::size_t end = i;
        std::size_t lowest = i;
        std::size_t highest = i;
        while (end < piece.size() && std::floor(2 * piece[end].x) == std::floor(2 * piece[i].x)) {
            if (piece[end].y < piece[lowest].y) lowest = end;
            if (piece[end].y > piece[highest].y) highest = end;
            ++end;
        }
        const std::size_t kept[] = {i, std::min(lowest, highest), std::max(lowest, highest), end - 1};
        for (std::size_t k = 0; k < 4; ++k) {
            if (k > 0 && kept[k] == kept[k - 1]) continue;
            path += (i == 0 && k == 0 ? "M" : "L") + number(piece[kept[k]].x) + " " + number(piece[kept[k]].y);
        }
        i = end;
    }
    if (piece.size() == 1) path += "h0";  // a dot, by the round cap of the line
}

/// Draws one curve and returns the position of its name: its last visible point, or the peak of a histogram.
std::optional<Pixel> draw_curve(std::string& out, const Series& series, std::size_t index, const Frame& frame,
                                const Axis_range& xs, const Axis_range& ys) {
    std::string path;
    std::vector<Pixel> piece;
    std::optional<Pixel> last;
    const auto finish = [&] {
        for (const Pixel& p : piece)
            if (!series.steps || !last || p.y < last->y) last = p;
        draw_piece(path, piece);
        piece.clear();
    };
    const auto add = [&](double x, double y) {
        piece.push_back({frame.x(std::clamp(xs.place(x), -0.01, 1.01)), frame.y(std::clamp(ys.place(y), -0.01, 1.01))});
    };
    const std::size_t size = std::min(series.x.size(), series.y.size());
    for (std::size_t i = 0; i < size; ++i) {
        const bool drawable = xs.can_show(series.x[i]) && ys.can_show(series.y[i]);
        if (!drawable) {
            finish();
            continue;
        }
        add(series.x[i], series.y[i]);
        if (series.steps && i + 1 < series.x.size() && xs.can_show(series.x[i + 1])) add(series.x[i + 1], series.y[i]);
    }
    finish();
    if (!path.empty()) out += "<path class=\"curve " + style(index) + "\" d=\"" + path + "\"/>";
    return last;
}

/// Draws the error bars. On a logarithmic scale a bar that reaches below 0 extends to the border.
void draw_errors(std::string& out, const Series& series, std::size_t index, const Frame& frame, const Axis_range& xs,
                 const Axis_range& ys) {
    std::string path;
    for (std::size_t i = 0; i < std::min({series.x.size(), series.y.size(), series.error.size()}); ++i) {
        const double y = series.y[i], error = series.error[i];
        if (!(error > 0) || !xs.can_show(series.x[i]) || !ys.can_show(y) || !ys.can_show(y + error)) continue;
        const auto place = [&](double end) {
            return frame.y(ys.can_show(end) ? std::clamp(ys.place(end), 0.0, 1.0) : 0.0);
        };
        const std::string left = number(frame.x(std::clamp(xs.place(series.x[i]), 0.0, 1.0)) - 3);
        const std::string low = number(place(y - error)), high = number(place(y + error));
        path += "M" + left + " " + low + "h6m-3 0V" + high + "m-3 0h6";
    }
    if (!path.empty()) out += "<path class=\"bar c" + std::to_string(index % colours) + "\" d=\"" + path + "\"/>";
}

/// Writes the names of histograms above their peaks, clear of all bars; one that would cover another goes above it.
void draw_peak_names(std::string& out, const Plot& plot, const std::vector<std::optional<Pixel>>& peaks,
                     const Frame& frame, const Axis_range& xs, const Axis_range& ys) {
    std::vector<std::pair<Pixel, double>> placed;  // centre and half width
    const auto top_of_bars = [&](double from, double to) {
        double y = frame.y(0);
        for (const Series& s : plot.series)
            for (std::size_t i = 0; s.steps && i < s.y.size() && i + 1 < s.x.size(); ++i)
                if (xs.can_show(s.x[i]) && xs.can_show(s.x[i + 1]) && ys.can_show(s.y[i]) &&
                    frame.x(xs.place(s.x[i])) < to && frame.x(xs.place(s.x[i + 1])) > from)
                    y = std::min(y, frame.y(ys.place(s.y[i])));
        return y;
    };
    for (std::size_t i = 0; i < peaks.size(); ++i) {
        if (!peaks[i] || plot.series[i].name.empty()) continue;
        const double half = letter_width * static_cast<double>(letters(plot.series[i].name)) / 2;
        Pixel at{std::clamp(peaks[i]->x, frame.left + half + 4, width - half), 0};
        at.y = std::min(peaks[i]->y, top_of_bars(at.x - half, at.x + half)) - 11;
        const auto covers = [&](const std::pair<Pixel, double>& other) {
            return std::fabs(other.first.x - at.x) < other.second + half &&
                   std::fabs(other.first.y - at.y) < line_height;
        };
        while (std::any_of(placed.begin(), placed.end(), covers)) at.y -= 4;
        placed.emplace_back(at, half);
        out += "<text class=\"name m c" + std::to_string(i % colours) + "\" x=\"" + number(at.x) + "\" y=\"" +
               number(at.y) + "\" dy=\".34em\">" + escaped(plot.series[i].name) + "</text>";
    }
}

/// Writes the names beside the ends of their curves, moved apart where they would overlap and joined by a thin line.
void draw_names(std::string& out, const Plot& plot, const Frame& frame, const std::vector<std::optional<Pixel>>& ends) {
    std::vector<std::pair<double, std::size_t>> places;
    for (std::size_t i = 0; i < ends.size(); ++i)
        if (ends[i] && !plot.series[i].name.empty()) places.emplace_back(ends[i]->y, i);
    std::sort(places.begin(), places.end());
    for (std::size_t k = 1; k < places.size(); ++k)
        places[k].first = std::max(places[k].first, places[k - 1].first + line_height);
    // Names pushed below the frame move back up.
    double limit = height - bottom;
    for (std::size_t k = places.size(); k-- > 0; limit = places[k].first - line_height)
        places[k].first = std::min(places[k].first, limit);
    for (const auto& [y, i] : places) {
        const std::string colour = "c" + std::to_string(i % colours);
        const double x = frame.right + 10;
        out += "<path class=\"lead " + colour + "\" d=\"M" + number(ends[i]->x + 2) + " " + number(ends[i]->y) + "L" +
               number(x - 2) + " " + number(y) + "\"/>";
        out += "<text class=\"name " + colour + "\" x=\"" + number(x) + "\" y=\"" + number(y) + "\" dy=\".34em\">" +
               escaped(plot.series[i].name) + "</text>";
    }
}

}  // namespace

Series histogram_series(std::string name, const Histogram& histogram) {
    // More than one empty bin at an end would only waste room.
    const auto edges = histogram.edges();
    const auto counts = histogram.counts();
    std::size_t first = 0, end = counts.size();
    while (first + 2 < end && counts[first] == 0 && counts[first + 1] == 0) ++first;
    while (first + 2 < end && counts[end - 1] == 0 && counts[end - 2] == 0) --end;
    Series series{std::move(name), {}, {}, true};
    for (std::size_t i = first; i < end; ++i) {
        series.x.push_back(edges[i]);
        series.y.push_back(100 * histogram.share(i));
    }
    if (first < end) series.x.push_back(edges[end]);
    return series;
}

std::string svg_plot(const Plot& plot) {
    std::vector<double> all_x;
    std::vector<double> all_y;
    for (const Series& s : plot.series) {
        all_x.insert(all_x.end(), s.x.begin(), s.x.end());
        all_y.insert(all_y.end(), s.y.begin(), s.y.end());
        for (std::size_t i = 0; i < std::min(s.y.size(), s.error.size()); ++i)
            if (s.error[i] > 0) all_y.insert(all_y.end(), {s.y[i] - s.error[i], s.y[i] + s.error[i]});
        if (!s.steps || s.y.empty()) continue;
        all_y.push_back(0);  // bars begin at zero, and their names need room above
        all_y.push_back(1.12 * *std::max_element(s.y.begin(), s.y.end()));
    }
    const Axis_range xs(plot.x, all_x);
    const Axis_range ys(plot.y, all_y);
    const Frame frame = frame_for(plot, ys);
    std::string out =
        "<svg class=\"plot\" viewBox=\"0 0 520 360\" role=\"img\" aria-label=\"" + escaped(plot.title) + "\">";
    draw_axes(out, plot, frame, xs, ys);
    std::vector<std::optional<Pixel>> ends;
    std::vector<std::optional<Pixel>> peaks;
    for (std::size_t i = 0; i < plot.series.size(); ++i) {
        const auto at = draw_curve(out, plot.series[i], i, frame, xs, ys);
        draw_errors(out, plot.series[i], i, frame, xs, ys);
        ends.push_back(plot.series[i].steps ? std::nullopt : at);
        peaks.push_back(plot.series[i].steps ? at : std::nullopt);
    }
    draw_names(out, plot, frame, ends);
    draw_peak_names(out, plot, peaks, frame, xs, ys);
    return out + "</svg>";
}

}  // namespace annulus::inline v1
