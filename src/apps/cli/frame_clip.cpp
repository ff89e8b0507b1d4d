// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/frame_clip.h>

#include <annulus/error.h>
#include <apps/cli/arguments.h>
#include <apps/formats/input_error.h>
#include <apps/motion/cell_2.h>

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

namespace {

[[noreturn]] void refuse(const std::string& fault) { throw Error(Error_code::usage, "--clip: " + fault); }

/// The kind before the colon, and the numbers.
std::pair<std::string, std::vector<double>> parts_of(const std::string& words) {
    const std::size_t colon = words.find(':');
    const std::string kind = colon == std::string::npos ? "box" : words.substr(0, colon);
    if (kind != "box" && kind != "polygon" && kind != "half-spaces")
        refuse("'" + kind + "' is no kind of clip; there are box:LIST, polygon:LIST and half-spaces:LIST");
    return {kind, parse_numbers("--clip", colon == std::string::npos ? words : words.substr(colon + 1))};
}

/// Fewest rows of a kind of clip, most rows (0: any number), and numbers in a row.
struct Shape {
    std::size_t least, most, width;
};

Voronoi_clip<2> polygon_of(const std::vector<std::vector<double>>& rows) {
    std::vector<Coordinates<2>> corners;
    for (const auto& row : rows) corners.push_back({row[0], row[1]});
    const Domain_2 domain = Domain_2::polygon(corners);
    Voronoi_clip<2> clip{domain.bounding_box().lower, domain.bounding_box().upper, {}};
    for (const Half_plane_2& edge : domain.edges()) clip.half_spaces.push_back({edge.normal, edge.bound});
    return clip;
}

}  // namespace

template <int d>
Clip_record parse_clip(const std::string& words) {
    const auto [kind, numbers] = parts_of(words);
    if (kind == "polygon" && d == 3)
        refuse("a polygon clips in 2D, and the points are in 3D; there is half-spaces:LIST");
    const auto [least, most, width] = kind == "box"       ? Shape{2, 2, d}
                                      : kind == "polygon" ? Shape{3, 0, d}
                                                          : Shape{d + 1, 0, d + 1};
    if (numbers.size() % width != 0 || numbers.size() < least * width || (most > 0 && numbers.size() > most * width))
        refuse(counted(numbers.size(), "number") + "; in " + std::to_string(d) + "D " +
               (kind == "box"       ? "a box has " + std::to_string(2 * d) + ", its lower and its upper corner"
                : kind == "polygon" ? std::string("a polygon has 2 for each corner, and 3 corners at least")
                                    : "a clip has " + std::to_string(d + 1) + " for each half-space, and " +
                                          std::to_string(d + 1) + " half-spaces at least"));
    Clip_record clip{kind, {}};
    for (auto row = numbers.begin(); row != numbers.end(); row += static_cast<std::ptrdiff_t>(width))
        clip.rows.emplace_back(row, row + static_cast<std::ptrdiff_t>(width));
    return clip;
}

void check_clip(const std::string& words) { (void)parts_of(words); }

template <int d>
Voronoi_clip<d> clip_of(const Clip_record& clip) {
    const auto& rows = clip.rows;
    try {
        if constexpr (d == 2)
            if (clip.kind == "polygon") return polygon_of(rows);
        Voronoi_clip<d> out;
        if (clip.kind == "box") {
            std::copy_n(rows[0].begin(), d, out.lower.begin());
            std::copy_n(rows[1].begin(), d, out.upper.begin());
            for (std::size_t k = 0; k < d; ++k)
                if (!(out.lower[k] < out.upper[k])) refuse("the lower corner of a box comes first, then the upper one");
            return out;
        }
        std::vector<Half_space<d>> half_spaces;
        for (const auto& row : rows) {
            std::copy_n(row.begin(), d, half_spaces.emplace_back().normal.begin());
            half_spaces.back().offset = -row[static_cast<std::size_t>(d)];
        }
        return voronoi_clip<d>(half_spaces);
    } catch (const Error& error) {
        if (error.code() == Error_code::usage) throw;
        refuse(error.what());
    }
}

Domain_2 domain_of(const Clip_record& record) {
    std::vector<Coordinates<2>> corners;
    if (record.kind == "polygon") {
        for (const auto& row : record.rows) corners.push_back({row[0], row[1]});
        return Domain_2::polygon(corners);
    }
    const auto [low, high, half_spaces] = clip_of<2>(record);
    corners = {low, {high[0], low[1]}, high, {low[0], high[1]}};
    Clipper_2 clipper;
    clipper.start(corners, std::vector<Half_plane_2>{
                               {{0, -1}, -low[1]}, {{1, 0}, high[0]}, {{0, 1}, high[1]}, {{-1, 0}, -low[0]}});
    for (const auto& [normal, offset] : half_spaces) clipper.clip({normal, offset});
    std::vector<Corner_2> cut;
    clipper.write_corners(cut);
    corners.clear();
    for (const Corner_2& corner : cut) corners.push_back(corner.offset);
    return Domain_2::convex_hull_of(corners);
}

template Clip_record parse_clip<2>(const std::string&);
template Clip_record parse_clip<3>(const std::string&);
template Voronoi_clip<2> clip_of<2>(const Clip_record&);
template Voronoi_clip<3> clip_of<3>(const Clip_record&);

}  // namespace annulus::inline v1::cli
