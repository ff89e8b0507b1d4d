// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/formats/format.h>

#include <cstdint>
#include <span>
#include <string>

namespace annulus::inline v1 {

/// Appends a frame in the format of its reader (frame_readers.h); the ids of points are their indices. Format is one of
/// written_formats; frames of one file are numbered from 0. Coordinates are the shortest decimals that read back as the
/// same doubles.
template <int d>
void append_frame(std::string& out, Format format, std::uint64_t number, std::span<const Coordinates<d>> points);

extern template void append_frame<2>(std::string&, Format, std::uint64_t, std::span<const Coordinates<2>>);
extern template void append_frame<3>(std::string&, Format, std::uint64_t, std::span<const Coordinates<3>>);

}  // namespace annulus::inline v1
