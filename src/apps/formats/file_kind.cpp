// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/formats/file_kind.h>

#include <array>

namespace annulus::inline v1 {

namespace {

using namespace std::string_view_literals;

constexpr Foreign_kind utf16{"is text in UTF-16", "text in UTF-8 or ASCII", Foreign::utf16};
constexpr Foreign_kind utf32{"is text in UTF-32", "text in UTF-8 or ASCII"};
constexpr std::string_view unpacked = "the file unpacked, or packed by gzip";
constexpr std::string_view table = "points as text";

struct Mark {
    std::string_view bytes;
    Foreign_kind kind;
};

/// Of two that begin alike the longer comes first.
constexpr std::array marks{
    Mark{"\xff\xfe\0\0"sv, utf32},
    Mark{"\0\0\xfe\xff"sv, utf32},
    Mark{"\xff\xfe"sv, utf16},
    Mark{"\xfe\xff"sv, utf16},
    Mark{"BZh"sv, {"is packed by bzip2", unpacked}},
    Mark{"\xfd\x37zXZ\0"sv, {"is packed by xz", unpacked}},
    Mark{"\x28\xb5\x2f\xfd"sv, {"is packed by zstd", unpacked}},
    Mark{"\x04\x22\x4d\x18"sv, {"is packed by lz4", unpacked}},
    Mark{"LZIP"sv, {"is packed by lzip", unpacked}},
    Mark{"\x1f\x9d"sv, {"is packed by compress", unpacked}},
    Mark{"PK\x03\x04"sv, {"is a zip archive (spreadsheets and .npz are, too)", unpacked}},
    Mark{"7z\xbc\xaf\x27\x1c"sv, {"is a 7z archive", unpacked}},
    Mark{"Rar!\x1a\x07"sv, {"is a rar archive", unpacked}},
    Mark{"\x93NUMPY"sv, {"is an array of NumPy", "points as text, or the name .npy", Foreign::numpy}},
    Mark{"\x89HDF\r\n\x1a\n"sv, {"is an HDF5 file", table}},
    Mark{"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"sv, {"is a document of an old office program", table}},
    Mark{"%PDF-"sv, {"is a PDF file", table}},
    Mark{"PAR1"sv, {"is a Parquet file", table}},
};

bool is_ascii(char c) { return (c >= ' ' && c <= '~') || (c >= '\t' && c <= '\r'); }

/// Text without a byte order mark, in units of `width` bytes: the byte at `place` in the unit is ASCII, the others are
/// 0.
bool is_wide_ascii(std::string_view bytes, std::size_t width, std::size_t place) {
    if (bytes.size() < 2 * width) return false;
    for (std::size_t i = 0; i < 2 * width; ++i)
        if (i % width == place ? !is_ascii(bytes[i]) : bytes[i] != '\0') return false;
    return true;
}

}  // namespace

bool begins_as_gzip(std::string_view bytes) noexcept { return bytes.starts_with("\x1f\x8b"sv); }

std::optional<Foreign_kind> foreign_kind(std::string_view bytes) noexcept {
    for (const Mark& mark : marks)
        if (bytes.starts_with(mark.bytes)) return mark.kind;
    if (is_wide_ascii(bytes, 4, 0) || is_wide_ascii(bytes, 4, 3)) return utf32;
    if (is_wide_ascii(bytes, 2, 0) || is_wide_ascii(bytes, 2, 1)) return utf16;
    return std::nullopt;
}

}  // namespace annulus::inline v1
