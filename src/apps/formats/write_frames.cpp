// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/decimal.h>
#include <apps/formats/write_frames.h>

#include <algorithm>
#include <string_view>

namespace annulus::inline v1 {

namespace {

constexpr std::string_view axes = "xyz";

/// A box around the points; LAMMPS has three directions.
template <int d>
void append_bounds(std::string& out, std::span<const Coordinates<d>> points) {
    for (std::size_t k = 0; k < 3; ++k) {
        double low = -0.5, high = 0.5;
        if (k < d && !points.empty()) {
            const auto [least, most] = std::minmax_element(points.begin(), points.end(),
                                                           [k](const auto& a, const auto& b) { return a[k] < b[k]; });
            low = (*least)[k];
            high = (*most)[k];
        }
        append_decimal(out, low);
        out += ' ';
        append_decimal(out, high);
        out += '\n';
    }
}

}  // namespace

template <int d>
void append_frame(std::string& out, Format format, std::uint64_t number, std::span<const Coordinates<d>> points) {
    const char separator = format == Format::csv ? ',' : ' ';
    const std::string n = std::to_string(points.size()), frame = std::to_string(number);
    if (format == Format::xyz) {
        out += n + "\nProperties=id:I:1:pos:R:" + std::to_string(d) + " frame=" + frame + "\n";
    } else if (format == Format::lammps) {
        out += "ITEM: TIMESTEP\n" + frame + "\nITEM: NUMBER OF ATOMS\n" + n + "\nITEM: BOX BOUNDS ff ff ff\n";
        append_bounds<d>(out, points);
        out += "ITEM: ATOMS id";
        for (std::size_t k = 0; k < d; ++k) out += std::string(" ") + axes[k];
        out += '\n';
    } else if (number == 0) {
        out += "frame,id";
        for (std::size_t k = 0; k < d; ++k) out += std::string(",") + axes[k];
        out += '\n';
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (format == Format::csv) out += frame + ",";
        append_decimal(out, i);
        for (const double c : points[i]) {
            out += separator;
            append_decimal(out, c);
        }
        out += '\n';
    }
}

template void append_frame<2>(std::string&, Format, std::uint64_t, std::span<const Coordinates<2>>);
template void append_frame<3>(std::string&, Format, std::uint64_t, std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
