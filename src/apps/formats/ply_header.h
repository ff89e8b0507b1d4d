// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/text_input.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

enum class Ply_format { ascii, binary_little_endian, binary_big_endian };

enum class Ply_type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

/// Bytes of one value.
[[nodiscard]] std::size_t ply_size(Ply_type type) noexcept;

/// The value of `ply_size(type)` bytes, least significant first. Every type fits in a double exactly.
[[nodiscard]] double ply_decode(Ply_type type, const char* little_endian) noexcept;

struct Ply_property {
    std::string name;
    Ply_type type = Ply_type::float64;
    bool is_list = false;
    Ply_type length_type = Ply_type::uint8;  ///< an integer type; used when this is a list
};

struct Ply_element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Ply_property> properties;

    /// Bytes of a binary record when all its lists are empty.
    [[nodiscard]] std::uint64_t least_bytes() const noexcept;
};

struct Ply_header {
    Ply_format format = Ply_format::ascii;
    std::vector<Ply_element> elements;
};

/// Which properties of a vertex are its coordinates.
struct Ply_vertex_columns {
    std::size_t x = 0;
    std::size_t y = 0;
    std::optional<std::size_t> z;

    [[nodiscard]] bool uses(std::size_t i) const noexcept { return i == x || i == y || (z && i == *z); }
};

/// Reads from "ply" to "end_header"; the reader is left on that last line. Throws Input_error.
[[nodiscard]] Ply_header read_ply_header(Line_reader& reader);

/// Finds x, y and z among the properties of the one element `vertex`; faults are reported at the reader's line.
[[nodiscard]] Ply_vertex_columns ply_vertex_columns(const Ply_header& header, const Line_reader& reader);

}  // namespace annulus::inline v1
