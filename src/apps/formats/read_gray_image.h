// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/text_input.h>
#include <apps/motion/stippling.h>

#include <filesystem>

namespace annulus::inline v1 {

/// Whether the name is that of a picture that `read_gray_image` takes: .png, .jpg, .jpeg, .pgm, .ppm, .pbm or .pnm,
/// either case, also with .gz.
[[nodiscard]] bool is_gray_image(const std::filesystem::path& file);

/// Reads a picture as grey values, as they are in the file, ignoring gamma; colours become their luma (ITU-R BT.709).
/// PBM, PGM and PPM, P1 to P6, of up to 16 bits, by Netpbm, whichever of these the extension names, as in Netpbm's
/// programs; PNG of any kind, by libpng, transparent pixels blended with white; JPEG, grey or in colours, of 8 bits, by
/// libjpeg, turned as its Exif orientation says.
///
/// Throws Input_error for every fault of the file. 2^26 pixels and 2^17 in a row at most. Memory is allocated when the
/// file is long enough to hold the pixels that its header announces.
[[nodiscard]] Gray_image read_gray_image(const std::filesystem::path& file);

// One file each.
[[nodiscard]] Gray_image read_pnm(Source source);
[[nodiscard]] Gray_image read_png(const Source& source);
[[nodiscard]] Gray_image read_jpeg(const Source& source);

/// The luma of a colour by ITU-R BT.709, rounded to the nearest. Precondition: each is below 2^16.
[[nodiscard]] std::uint16_t luma(std::uint64_t red, std::uint64_t green, std::uint64_t blue);

/// Checks and sets the size that a header announces on this line.
void set_size(Gray_image& image, std::uint64_t width, std::uint64_t height, const std::string& name,
              std::uint64_t line);

}  // namespace annulus::inline v1
