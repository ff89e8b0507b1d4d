// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/formats/input_error.h>
#include <annulus/motion/labelled_image.h>

#include <filesystem>

namespace annulus {

/// Reads a labelled image, INRIMAGE-4 with unsigned labels of 8 bits (.inr, or .inr.gz by gzip; either case).
///
/// Throws Input_error for everything that is wrong with the file, which includes a length that differs from what its
/// header says. Memory is asked for as the file fills it, never on the word of the header, and nothing is unpacked
/// beyond what the header announces.
[[nodiscard]] Labelled_image read_image(const std::filesystem::path& file);

}  // namespace annulus
