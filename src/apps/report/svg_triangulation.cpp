// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/error.h>
#include <apps/formats/markup.h>
#include <apps/report/axis_ticks.h>
#include <apps/report/svg_triangulation.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace annulus::inline v1 {

namespace {

constexpr double side = 10000;  ///< of the drawing; whole units are fine enough, and short
constexpr double margin = 150;  ///< around a whole picture; a window is cut off at the frame

struct Grid_point {
    long x = 0;
    long y = 0;
};

Grid_point place(const Window& window, const Coordinates<2>& p) {
    const double scale = (window.whole ? side - 2 * margin : side) / (2 * window.half_side);
    // Far outside the window only the direction matters, and long must hold the result.
    const auto to_grid = [&](double offset) { return std::lround(std::clamp(side / 2 + offset * scale, -1e6, 1e6)); };
    return {to_grid(p[0] - window.centre[0]), to_grid(window.centre[1] - p[1])};
}

double distance(const Window& window, const Coordinates<2>& p) {
    return std::max(std::fabs(p[0] - window.centre[0]), std::fabs(p[1] - window.centre[1]));
}

bool inside(const Window& window, const Coordinates<2>& p) { return distance(window, p) <= window.half_side; }

void append_pair(std::string& out, long x, long y) {
    out += std::to_string(x);
    if (y >= 0) out += ' ';
    out += std::to_string(y);
}

/// Edges at each vertex, in one array.
struct Incidence {
    std::vector<std::size_t> first;  ///< of vertex i; one more at the end
    std::vector<std::size_t> edges;
};

Incidence incidence_of(const std::vector<std::array<Index, 2>>& edges, std::size_t vertices) {
    Incidence result;
    result.first.assign(vertices + 1, 0);
    for (const auto& e : edges)
        for (const Index i : e) ++result.first[static_cast<std::size_t>(i) + 1];
    for (std::size_t i = 0; i < vertices; ++i) result.first[i + 1] += result.first[i];
    result.edges.resize(2 * edges.size());
    std::vector<std::size_t> next(result.first.begin(), result.first.end() - 1);
    for (std::size_t k = 0; k < edges.size(); ++k)
        for (const Index i : edges[k]) result.edges[next[static_cast<std::size_t>(i)]++] = k;
    return result;
}

/// Every edge once, in trails as long as possible: a trail needs one pair of numbers per edge instead of two.
std::string trails(const std::vector<std::array<Index, 2>>& edges, const std::vector<Grid_point>& at) {
    const Incidence incidence = incidence_of(edges, at.size());
    std::vector<char> drawn(edges.size(), 0);
    std::vector<std::size_t> next(incidence.first.begin(), incidence.first.end() - 1);
    std::string out;
    for (std::size_t start = 0; start < at.size(); ++start) {
        std::size_t v = start;
        bool pen_down = false;
        for (;;) {
            while (next[v] < incidence.first[v + 1] && drawn[incidence.edges[next[v]]]) ++next[v];
            if (next[v] == incidence.first[v + 1]) {
                if (!pen_down) break;
                v = start;  // the trail is stuck; there may be another from its start
                pen_down = false;
                continue;
            }
            const std::size_t edge = incidence.edges[next[v]];
            drawn[edge] = 1;
            const auto a = static_cast<std::size_t>(edges[edge][0]);
            const auto w = a == v ? static_cast<std::size_t>(edges[edge][1]) : a;
            if (!pen_down) {
                out += 'M';
                append_pair(out, at[v].x, at[v].y);
                out += 'l';
            } else if (at[w].x >= at[v].x) {
                out += ' ';  // a minus separates numbers by itself
            }
            append_pair(out, at[w].x - at[v].x, at[w].y - at[v].y);
            pen_down = true;
            v = w;
        }
    }
    return out;
}

void append_outline(std::string& out, const std::vector<Coordinates<2>>& corners, const Window& window) {
    if (corners.size() < 3) return;
    Grid_point last = place(window, corners[0]);
    out += 'M';
    append_pair(out, last.x, last.y);
    out += 'l';
    for (std::size_t i = 1; i < corners.size(); ++i) {
        const Grid_point next = place(window, corners[i]);
        if (i > 1 && next.x >= last.x) out += ' ';  // a minus separates numbers by itself
        append_pair(out, next.x - last.x, next.y - last.y);
        last = next;
    }
    out += 'z';
}

/// The faces of one shade, with a corner in the window, as a path.
std::string outlines(const Picture& picture, const Window& window, unsigned char shade) {
    const auto enters = [&](const std::vector<Coordinates<2>>& corners) {
        return std::any_of(corners.begin(), corners.end(), [&](const auto& p) { return inside(window, p); });
    };
    std::string out;
    for (const Face& face : picture.faces) {
        if (face.shade != shade) continue;
        if (!window.whole && !enters(face.corners) && std::none_of(face.more.begin(), face.more.end(), enters))
            continue;
        append_outline(out, face.corners, window);
        for (const auto& outline : face.more) append_outline(out, outline, window);
    }
    return out;
}

}  // namespace

std::string counted_dots(std::size_t n, Dots dots) {
    return grouped(n) + (dots == Dots::vertices ? (n == 1 ? " vertex" : " vertices")
                         : dots == Dots::images ? (n == 1 ? " vertex or image" : " vertices and images")
                                                : (n == 1 ? " cut edge" : " cut edges"));
}

Window window_of(const std::vector<Coordinates<2>>& points, std::size_t most, std::size_t within) {
    Window window;
    if (points.empty()) return window;
    Coordinates<2> lower = points[0];
    Coordinates<2> upper = points[0];
    for (const auto& p : points)
        for (std::size_t k = 0; k < 2; ++k) {
            lower[k] = std::min(lower[k], p[k]);
            upper[k] = std::max(upper[k], p[k]);
        }
    window.centre = {lower[0] / 2 + upper[0] / 2, lower[1] / 2 + upper[1] / 2};
    window.half_side = std::max(upper[0] / 2 - lower[0] / 2, upper[1] / 2 - lower[1] / 2);
    window.whole = points.size() <= most;
    if (!window.whole) {
        std::vector<double> distances;
        distances.reserve(points.size());
        for (const auto& p : points) distances.push_back(distance(window, p));
        const auto nth = distances.begin() + static_cast<std::ptrdiff_t>(std::min(within, points.size()) - 1);
        std::nth_element(distances.begin(), nth, distances.end());
        window.half_side = *nth;
    }
    if (!(window.half_side > 0)) window.half_side = 1;  // all points in one place
    return window;
}

std::size_t points_in(const Window& window, const std::vector<Coordinates<2>>& points) {
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [&](const auto& p) { return inside(window, p); }));
}

std::string svg_triangulation(const Picture& picture, const Window& window) {
    std::vector<Grid_point> at;
    at.reserve(picture.points.size());
    for (const auto& p : picture.points) at.push_back(place(window, p));
    std::vector<std::array<Index, 2>> edges;
    for (const auto& e : picture.edges) {
        for (const Index i : e)
            if (i < 0 || static_cast<std::size_t>(i) >= at.size())
                throw Error(Error_code::unknown_vertex, "svg_triangulation: an edge names no point");
        if (e[0] == e[1]) continue;
        const auto& p = picture.points[static_cast<std::size_t>(e[0])];
        const auto& q = picture.points[static_cast<std::size_t>(e[1])];
        if (window.whole || inside(window, p) || inside(window, q)) edges.push_back(e);
    }
    std::string dots;
    std::size_t shown = 0;
    for (std::size_t i = 0; i < at.size(); ++i) {
        if (!inside(window, picture.points[i])) continue;
        ++shown;
        if (picture.dots == Dots::crossings) continue;
        dots += 'M';
        append_pair(dots, at[i].x, at[i].y);
        dots += "h0";
    }
    // Lines and dots scale with the spacing of the vertices.
    const double spacing = side / std::sqrt(static_cast<double>(std::max<std::size_t>(shown, 1)));
    const auto thickness = [](double units) { return std::to_string(std::lround(units)); };
    std::string out =
        "<svg class=\"mesh\" viewBox=\"0 0 10000 10000\" role=\"img\" aria-label=\"" + escaped(picture.caption) + "\">";
    const std::string line = thickness(std::clamp(0.05 * spacing, 5., 22.));
    for (unsigned char shade = 0; !picture.faces.empty() && shade < 6; ++shade) {
        const std::string path = outlines(picture, window, shade);
        if (!path.empty())
            out += std::string("<path class=\"face ") + (picture.shading == Shading::neighbours ? 'n' : 'q') +
                   std::to_string(shade) + "\" stroke-width=\"" + line + "\" d=\"" + path + "\"/>";
    }
    if (!edges.empty() || picture.faces.empty())
        out += "<path class=\"edges\" stroke-width=\"" + line + "\" d=\"" + trails(edges, at) + "\"/>";
    std::string outline;
    for (const auto& ring : picture.outline) append_outline(outline, ring, window);
    if (!outline.empty()) out += "<path class=\"outline\" stroke-width=\"25\" d=\"" + outline + "\"/>";
    const double dot = std::clamp(0.22 * spacing, 20., 130.);
    if (picture.dots != Dots::crossings && !picture.faces.empty())  // visible on faces of any colour
        out += "<path class=\"halo\" stroke-width=\"" + thickness(1.6 * dot) + "\" d=\"" + dots + "\"/>";
    if (picture.dots != Dots::crossings)
        out += "<path class=\"dots\" stroke-width=\"" + thickness(dot) + "\" d=\"" + dots + "\"/>";
    return out + "</svg>";
}

}  // namespace annulus::inline v1
