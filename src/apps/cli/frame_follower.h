// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/frame_change.h>
#include <apps/cli/frame_files.h>
#include <apps/cli/replay_scene.h>
#include <apps/cli/tracker.h>

#include <functional>
#include <string>

namespace annulus::inline v1::cli {

/// How many points appeared, disappeared, and were merged with others.
struct Traffic {
    std::uint64_t arrived = 0, left = 0, merged = 0;

    [[nodiscard]] std::string in_words() const;
};

/// How a triangulation follows the frames of a file: all that a replay does differently with open boundaries and in a
/// periodic box.
///
/// `make` returns the function that builds the triangulation of the first frame, `begin` takes its points, and `step`
/// makes one time step; `files` is null where none are written. Frames are moved from.
template <class Moving>
class Frame_follower;

/// Open boundaries: removals, one move_all, insertions.
template <int d>
class Frame_follower<Moving_mesh<d>> {
  public:
    using Moving = Moving_mesh<d>;
    using Follows = Tracker<Moving>;
    explicit Frame_follower(const Replayed_frames<d>&) {}

    [[nodiscard]] std::function<Moving()> make(const Frame_points<d>& frame, const Options& options) const {
        return [&frame, options] { return Moving(frame.x, options); };
    }
    void begin(Frame_points<d>& frame, Frame_files<Moving>* files);
    void step(Follows& tracker, Frame_points<d>& frame, Frame_files<Moving>* files, Traffic& traffic);

  private:
    Present present_;
};

/// A periodic box: the points and the box of the frame. Throws Input_error where the frame cannot be triangulated.
template <int d>
class Frame_follower<Boxed_mesh<d>> {
  public:
    using Moving = Boxed_mesh<d>;
    using Follows = Run_tracker<Moving>;
    explicit Frame_follower(const Replayed_frames<d>& frames) : frames_(frames) {}

    [[nodiscard]] std::function<Moving()> make(const Frame_points<d>& frame, const Options& options) const;
    void begin(Frame_points<d>& frame, Frame_files<Moving>* files);
    void step(Follows& tracker, Frame_points<d>& frame, Frame_files<Moving>* files, Traffic& traffic);

  private:
    const Replayed_frames<d>& frames_;
};

extern template class Frame_follower<Moving_mesh<2>>;
extern template class Frame_follower<Moving_mesh<3>>;
extern template class Frame_follower<Boxed_mesh<2>>;
extern template class Frame_follower<Boxed_mesh<3>>;

}  // namespace annulus::inline v1::cli
