// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/boxed_scene.h>
#include <apps/cli/guided_motion.h>

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

// Motions in periodic boxes that strategies follow.
namespace annulus::inline v1::cli {

/// Lloyd iterations with their own triangulation, as Guided_lloyd.
template <int d>
class Guided_boxed_lloyd final : public Guided_motion<Boxed_mesh<d>> {
  public:
    using Moving = Boxed_mesh<d>;

    Guided_boxed_lloyd(const Lloyd_arguments& arguments, const std::string& box, const Common_arguments& common);
    [[nodiscard]] const char* step_name() const override { return "Lloyd iteration"; }
    [[nodiscard]] Moving start(const Options& options) const override { return scene_.mesh(options); }
    [[nodiscard]] double spacing() const override { return scene_.spacing(); }
    bool next(Boxed_step<d>& t) override;
    [[nodiscard]] Picture picture(const Moving& dt, std::string caption) const override {
        return picture_of(dt, std::move(caption), cut_);
    }
    [[nodiscard]] Input_record input() const { return scene_.input(); }

  private:
    Boxed_scene<d> scene_;
    Moving guide_;
    int threads_;
    mutable Chosen_cut cut_;  // of all pictures
};

/// A recorded motion. Its own triangulation finds what cannot be triangulated while the frame is there.
template <int d>
class Guided_boxed_replay final : public Guided_motion<Boxed_mesh<d>> {
  public:
    using Moving = Boxed_mesh<d>;

    /// Precondition: the frames exist as long as this object.
    explicit Guided_boxed_replay(Replayed_frames<d>& frames);
    [[nodiscard]] const char* step_name() const override { return "frame"; }
    [[nodiscard]] bool replayed() const override { return true; }
    [[nodiscard]] Moving start(const Options& options) const override {
        return Moving(first_.id, first_.x, *first_.box, options);
    }
    [[nodiscard]] double spacing() const override { return frames_.spacing(); }
    bool next(Boxed_step<d>& t) override;
    [[nodiscard]] bool at_end() override { return frames_.at_end(); }
    [[nodiscard]] Picture picture(const Moving& dt, std::string caption) const override {
        return picture_of(dt, std::move(caption), cut_);
    }

  private:
    [[nodiscard]] Moving first_frame();

    Replayed_frames<d>& frames_;
    Frame_points<d> frame_;
    Boxed_step<d> first_;
    Moving guide_;
    mutable Chosen_cut cut_;  // of all pictures
};

extern template class Guided_boxed_lloyd<2>;
extern template class Guided_boxed_lloyd<3>;
extern template class Guided_boxed_replay<2>;
extern template class Guided_boxed_replay<3>;

}  // namespace annulus::inline v1::cli
