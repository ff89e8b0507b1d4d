// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/cli/frame_change.h>
#include <apps/cli/lloyd_scene.h>
#include <apps/cli/mesh_3.h>
#include <apps/cli/replay_scene.h>
#include <apps/cli/tracker.h>
#include <apps/motion/lloyd_2.h>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace annulus::inline v1::cli {

/// One time step: the indices of the vertices that leave, the new positions of the others by index, and the points that
/// arrive after that.
template <int d>
struct Time_step {
    std::vector<Index> leave{};
    std::vector<Coordinates<d>> x{}, arrive{};
    Displacement way{};
    double seconds = 0;  ///< time that the motion took

    [[nodiscard]] std::size_t bytes() const { return (x.size() + arrive.size()) * sizeof(Coordinates<d>); }
};

/// In a periodic box: all points, in the order of their ids, and the box.
template <int d>
struct Boxed_step {
    std::vector<std::uint64_t> id{};
    std::vector<Coordinates<d>> x{};
    std::optional<Box<d>> box{};  ///< there always
    Displacement way{};
    double seconds = 0;  ///< time that the motion took

    [[nodiscard]] std::size_t bytes() const { return x.size() * (sizeof(Coordinates<d>) + sizeof(std::uint64_t)); }
};

/// A motion that strategies follow: the triangulation of its initial points, and its time steps.
template <class Moving_>
class Guided_motion {
  public:
    using Moving = Moving_;
    static constexpr int d = Moving::dimension_of_space;
    using Step = std::conditional_t<Open_mesh<Moving>, Time_step<d>, Boxed_step<d>>;

    virtual ~Guided_motion() = default;
    [[nodiscard]] virtual const char* step_name() const = 0;
    /// Whether the steps are from frame to frame of a file.
    [[nodiscard]] virtual bool replayed() const { return false; }
    [[nodiscard]] virtual Moving start(const Options& options) const = 0;
    /// The unit of lengths.
    [[nodiscard]] virtual double spacing() const = 0;
    /// Computes the next time step; false if there is none.
    virtual bool next(Step& t) = 0;
    [[nodiscard]] virtual bool at_end() { return false; }
    /// A picture of one of the triangulations that follow the motion.
    [[nodiscard]] virtual Picture picture(const Moving& dt, std::string caption) const = 0;
};

/// Lloyd iterations with their own triangulation, which is kept by certified tolerances and not timed, so that the
/// motion does not depend on the triangulations that follow it.
class Guided_lloyd final : public Guided_motion<Moving_mesh_2> {
  public:
    Guided_lloyd(const Lloyd_arguments& arguments, const Common_arguments& common);
    [[nodiscard]] const char* step_name() const override { return "Lloyd iteration"; }
    [[nodiscard]] const std::vector<Coordinates<2>>& points() const { return scene_.points; }
    [[nodiscard]] Moving start(const Options& options) const override { return Moving(points(), options); }
    [[nodiscard]] double spacing() const override { return scene_.spacing(); }
    bool next(Time_step<2>& t) override;
    [[nodiscard]] Picture picture(const Moving& dt, std::string caption) const override;
    /// The triangulation that the motion itself uses.
    [[nodiscard]] const Moving& guide() const { return guide_; }
    [[nodiscard]] const std::vector<std::string>& notes() const { return scene_.input.warnings; }
    [[nodiscard]] const Input_record& input() const { return scene_.input; }

  private:
    Lloyd_scene scene_;
    Moving guide_;
    Lloyd_2 lloyd_;
    Stars_2 stars_;
    Lloyd_memory memory_;
    int threads_;
    bool cells_changed_ = true;
};

/// A recorded motion, which needs no triangulation. It assigns indices as a triangulation does: a point that arrives
/// gets the index that was freed last, or a new one.
template <class Moving>
class Guided_replay final : public Guided_motion<Moving> {
  public:
    static constexpr int d = Moving::dimension_of_space;

    /// Precondition: the frames exist as long as this object.
    explicit Guided_replay(Replayed_frames<d>& frames);
    [[nodiscard]] const char* step_name() const override { return "frame"; }
    [[nodiscard]] bool replayed() const override { return true; }
    [[nodiscard]] Moving start(const Options& options) const override { return Moving(x_, options); }
    [[nodiscard]] double spacing() const override { return frames_.spacing(); }
    bool next(Time_step<d>& t) override;
    [[nodiscard]] bool at_end() override { return frames_.at_end(); }
    [[nodiscard]] Picture picture(const Moving& dt, std::string caption) const override {
        return picture_of(dt, std::move(caption), cut_);
    }

  private:
    Replayed_frames<d>& frames_;
    Frame_points<d> frame_;
    Present present_;
    std::vector<Coordinates<d>> x_;
    std::vector<Index> free_indices_;
    mutable Chosen_cut cut_;  // of all pictures
};

extern template class Guided_replay<Moving_mesh_2>;
extern template class Guided_replay<Moving_mesh_3>;

}  // namespace annulus::inline v1::cli
