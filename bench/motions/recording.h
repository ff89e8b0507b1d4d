// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"

#include <apps/motion/recorded_motion.h>

#include <cstdint>
#include <vector>

namespace bench {

/// The motion in a file, as `annulus replay --coincident merge --absent-frames skip` follows it. A spacing is the
/// square root of the area of the fullest frame's box per point, in 3D the cube root of its volume.
template <int d>
class Recording : public Motion<d> {
  public:
    /// Begins at frame `first`, or the next one with points.
    explicit Recording(const annulus::Recorded_motion& recorded, std::size_t first = 0);

  private:
    using Motion<d>::x_;
    bool advance() override;

    const annulus::Recorded_motion& recorded_;
    std::size_t next_;  // frame
    // The present points, by ascending id.
    std::vector<std::uint64_t> id_;
    std::vector<Index> number_;
};

/// The first frame with the most points.
[[nodiscard]] std::size_t fullest(const annulus::Recorded_motion& recorded);

extern template class Recording<2>;
extern template class Recording<3>;

}  // namespace bench
