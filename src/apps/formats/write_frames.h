// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/box.h>
#include <annulus/types.h>
#include <apps/formats/format.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>

namespace annulus::inline v1 {

/// Appends a frame in the format of its reader (frame_readers.h); the ids of points are their indices. Format is one of
/// written_formats; frames of one file are numbered from 0. Coordinates are the shortest decimals that read back as the
/// same doubles. The frame has the periodic box, unless there is none; its vectors are read back exactly, too, in 2D
/// with a third one, 0 0 1. Precondition of a box: the format is not csv, which has no place for it.
template <int d>
void append_frame(std::string& out, Format format, std::uint64_t number, std::span<const Coordinates<d>> points,
                  const std::optional<Box<d>>& box = {});

extern template void append_frame<2>(std::string&, Format, std::uint64_t, std::span<const Coordinates<2>>,
                                     const std::optional<Box<2>>&);
extern template void append_frame<3>(std::string&, Format, std::uint64_t, std::span<const Coordinates<3>>,
                                     const std::optional<Box<3>>&);

}  // namespace annulus::inline v1
