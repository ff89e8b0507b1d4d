// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/formats/input_error.h>
#include <apps/motion/labelled_image.h>

#include <filesystem>

namespace annulus::inline v1 {

/// Reads a labelled image, INRIMAGE-4 with unsigned labels of 8 bits (.inr, or .inr.gz by gzip; either case).
///
/// Throws Input_error for every fault of the file, including a length that differs from the header's. Memory is
/// allocated as the file fills it, never by the header alone, and nothing is unpacked beyond the announced length.
[[nodiscard]] Labelled_image read_image(const std::filesystem::path& file);

}  // namespace annulus::inline v1
