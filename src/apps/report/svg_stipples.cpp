// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/report/axis_ticks.h>
#include <apps/report/svg_stipples.h>

#include <annulus/error.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace annulus::inline v1 {

std::string svg_stipples(std::size_t width, std::size_t height, std::span<const Coordinates<2>> points,
                         std::span<const double> radii, bool white_on_black) {
    if (radii.size() != points.size() && radii.size() != 1)
        throw Error(Error_code::wrong_size, "stipples need a radius each, or one for all");
    double sum = 0;
    for (const double r : radii) sum += r;
    const double mean = sum / static_cast<double>(radii.size());
    const int fine = mean > 0 ? std::clamp(static_cast<int>(std::ceil(-std::log10(mean / 10))), 0, 12) : 2;
    const auto number = [](double x, int digits) {
        char text[340];
        char* end = std::to_chars(text, text + sizeof text, x, std::chars_format::fixed, digits).ptr;
        if (digits > 0) {
            while (end[-1] == '0') --end;
            if (end[-1] == '.') --end;
        }
        return std::string(text, end);
    };
    const std::string w = std::to_string(width), h = std::to_string(height);
    const std::string paper = white_on_black ? "#000" : "#fff", ink = white_on_black ? "#fff" : "#000";
    std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
                      "\" viewBox=\"0 0 " + w + " " + h + "\">\n<title>" + grouped(points.size()) +
                      (points.size() == 1 ? " stipple" : " stipples") + "</title>\n<rect width=\"" + w +
                      "\" height=\"" + h + "\" fill=\"" + paper + "\"/>\n<g fill=\"" + ink + "\">\n";
    for (std::size_t i = 0; i < points.size(); ++i)
        out += "<circle cx=\"" + number(points[i][0], fine) + "\" cy=\"" +
               number(static_cast<double>(height) - points[i][1], fine) + "\" r=\"" +
               number(radii[radii.size() == 1 ? 0 : i], fine + 1) + "\"/>\n";
    return out + "</g>\n</svg>\n";
}

}  // namespace annulus::inline v1
