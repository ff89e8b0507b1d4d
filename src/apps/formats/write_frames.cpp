// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/decimal.h>
#include <apps/formats/write_frames.h>

#include <algorithm>
#include <array>
#include <string_view>

namespace annulus::inline v1 {

namespace {

constexpr std::string_view axes = "xyz";

/// A box around the points, not periodic; LAMMPS has three directions.
template <int d>
void append_bounds(std::string& out, std::span<const Coordinates<d>> points) {
    out += "ITEM: BOX BOUNDS ff ff ff\n";
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

/// The vectors, completed to three.
template <int d>
std::array<Coordinates<3>, 3> vectors_of(const Box<d>& box) {
    std::array<Coordinates<3>, 3> vectors{{{0, 0, 0}, {0, 0, 0}, {0, 0, 1}}};
    for (std::size_t i = 0; i < d; ++i) std::copy_n(box.vectors()[i].begin(), d, vectors[i].begin());
    return vectors;
}

void append_numbers(std::string& out, std::span<const double> numbers) {
    for (std::size_t k = 0; k < numbers.size(); ++k) {
        if (k > 0) out += ' ';
        append_decimal(out, numbers[k]);
    }
}

template <int d>
void append_lattice(std::string& out, const Box<d>& box) {
    out += "Lattice=\"";
    for (const auto& vector : vectors_of(box)) {
        if (out.back() != '"') out += ' ';
        append_numbers(out, vector);
    }
    out += d == 2 ? "\" pbc=\"T T F\" " : "\" pbc=\"T T T\" ";
}

/// The edges of an upright box along the axes, or three vectors; both with the corner at the origin. An oblique box as
/// xy xz yz would be read from the bounds of the upright box around it, with rounding.
template <int d>
void append_periodic_bounds(std::string& out, const Box<d>& box) {
    const auto vectors = vectors_of(box);
    bool upright = true;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t k = 0; k < 3; ++k) upright = upright && (i == k ? vectors[i][k] > 0 : vectors[i][k] == 0);
    out += upright ? "ITEM: BOX BOUNDS pp pp pp\n" : "ITEM: BOX BOUNDS abc origin pp pp pp\n";
    for (std::size_t i = 0; i < 3; ++i) {
        if (upright) {
            append_numbers(out, std::array{0.0, vectors[i][i]});
        } else {
            append_numbers(out, vectors[i]);
            out += " 0";
        }
        out += '\n';
    }
}

}  // namespace

template <int d>
void append_frame(std::string& out, Format format, std::uint64_t number, std::span<const Coordinates<d>> points,
                  const std::optional<Box<d>>& box) {
    const char separator = format == Format::csv ? ',' : ' ';
    const std::string n = std::to_string(points.size()), frame = std::to_string(number);
    if (format == Format::xyz) {
        out += n + "\n";
        if (box) append_lattice(out, *box);
        out += "Properties=id:I:1:pos:R:" + std::to_string(d) + " frame=" + frame + "\n";
    } else if (format == Format::lammps) {
        out += "ITEM: TIMESTEP\n" + frame + "\nITEM: NUMBER OF ATOMS\n" + n + "\n";
        if (box) append_periodic_bounds(out, *box);
        else append_bounds<d>(out, points);
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

template void append_frame<2>(std::string&, Format, std::uint64_t, std::span<const Coordinates<2>>,
                              const std::optional<Box<2>>&);
template void append_frame<3>(std::string&, Format, std::uint64_t, std::span<const Coordinates<3>>,
                              const std::optional<Box<3>>&);

}  // namespace annulus::inline v1
