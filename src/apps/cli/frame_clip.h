// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/voronoi.h>
#include <apps/motion/domain_2.h>
#include <apps/report/run_record.h>

#include <string>

namespace annulus::inline v1::cli {

/// The words of --clip: `LIST`, the lower and the upper corner of a box; `polygon:LIST`, the corners of a convex
/// polygon, in order; or `half-spaces:LIST`, a, b [, c], e of each, the positions with a x + b y [+ c z] + e <= 0. A
/// LIST is numbers separated by commas. Throws Error(usage) for other words, and where d dimensions have no such clip.
template <int d>
[[nodiscard]] Clip_record parse_clip(const std::string& words);

/// What can be checked before the dimension is found: throws Error(usage) unless these are numbers of a kind of clip.
void check_clip(const std::string& words);

/// The clip that parse_clip has read. Throws Error(usage) unless it is bounded and has an interior.
template <int d>
[[nodiscard]] Voronoi_clip<d> clip_of(const Clip_record& clip);

/// The region of a clip in 2D that clip_of takes. Throws Error for lengths that are not those of a Domain_2.
[[nodiscard]] Domain_2 domain_of(const Clip_record& clip);

extern template Clip_record parse_clip<2>(const std::string&);
extern template Clip_record parse_clip<3>(const std::string&);
extern template Voronoi_clip<2> clip_of<2>(const Clip_record&);
extern template Voronoi_clip<3> clip_of<3>(const Clip_record&);

}  // namespace annulus::inline v1::cli
