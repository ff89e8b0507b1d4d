// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/report/svg_triangulation.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1 {

/// Pictures of a run of unknown length, for a page with a slider: every frame, then every second one, every fourth ..,
/// so that there are never more than most_pictures; of many vertices only a window in the middle is shown. Memory does
/// not grow with the run.
class Film {
  public:
    static constexpr std::size_t most_pictures = 40;
    static constexpr std::size_t most_vertices = 2000;  ///< else a window with about half as many

    /// Whether add() would keep the picture of frame `number`, counted from 0.
    [[nodiscard]] bool includes(std::uint64_t number) const { return number % stride_ == 0; }
    /// Numbers of frames ascend. The last frame is always kept.
    void add(std::uint64_t number, Picture picture, bool last = false);

    [[nodiscard]] bool empty() const { return pictures_.empty(); }
    /// The film as a part of a page: pictures in one frame, a slider, and a caption that says which part is shown.
    /// Without scripts the pictures are one below the other.
    [[nodiscard]] std::string html() const;

  private:
    void clip(Picture& picture);

    struct Shot {
        std::uint64_t number;
        Picture picture;
        std::size_t points;  // before clipping
    };
    std::vector<Shot> pictures_;
    std::uint64_t stride_ = 1;
    std::uint64_t frames_ = 0;
    std::optional<Window> window_;  // the part that is drawn, once there were too many vertices
};

}  // namespace annulus::inline v1
