// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/cli/frame_change.h>
#include <annulus/cli/lloyd_scene.h>
#include <annulus/cli/mesh_3.h>
#include <annulus/cli/nodt_scene.h>
#include <annulus/cli/replay_scene.h>
#include <annulus/cli/tracker.h>
#include <annulus/motion/lloyd_2.h>
#include <annulus/motion/nodt_3.h>

#include <span>
#include <string>
#include <utility>
#include <vector>

namespace annulus::cli {

/// How far the vertices go in a step.
struct Way {
    double mean = 0, max = 0;
};

/// One timestamp: who leaves, where the others go, by index, and who arrives then.
template <int d>
struct Timestamp {
    std::vector<Index> leave{};
    std::vector<Coordinates<d>> x{}, arrive{};
    Way way{};
    double seconds = 0;  ///< that the motion took

    [[nodiscard]] std::size_t bytes() const { return (x.size() + arrive.size()) * sizeof(Coordinates<d>); }
};

/// Lloyd iterations with a triangulation of their own, kept by certified tolerances and timed for nobody, so that what
/// follows them does not decide where they go.
class Guided_lloyd {
  public:
    using Moving = Moving_mesh_2;
    static constexpr const char* step_name = "Lloyd iteration";

    Guided_lloyd(const Lloyd_arguments& arguments, const Common_arguments& common);
    [[nodiscard]] const std::vector<Coordinates<2>>& points() const { return scene_.points; }
    [[nodiscard]] double spacing() const { return scene_.spacing(); }
    /// The next timestamp; false where there is none.
    bool next(Timestamp<2>& t);
    [[nodiscard]] static bool at_end() { return false; }
    [[nodiscard]] Picture picture(const Moving& dt, std::string caption) const;
    /// The triangulation of its own.
    [[nodiscard]] const Moving& guide() const { return guide_; }
    [[nodiscard]] const std::vector<std::string>& notes() const { return scene_.input.warnings; }
    [[nodiscard]] const Input_record& input() const { return scene_.input; }

  private:
    Lloyd_scene scene_;
    Moving guide_;
    Lloyd_2 lloyd_;
    Stars_2 stars_;
    Lloyd_memory memory_;
    bool cells_changed_ = true;
};

/// The same of natural ODT.
class Guided_nodt {
  public:
    using Moving = Moving_mesh_3;
    static constexpr const char* step_name = "natural ODT iteration";

    Guided_nodt(const Nodt_arguments& arguments, const Common_arguments& common);
    [[nodiscard]] const std::vector<Coordinates<3>>& points() const { return scene_.points; }
    [[nodiscard]] double spacing() const { return scene_.spacing(); }
    bool next(Timestamp<3>& t);
    [[nodiscard]] static bool at_end() { return false; }
    [[nodiscard]] Picture picture(const Moving& dt, std::string caption) const;
    [[nodiscard]] const Moving& guide() const { return guide_; }
    [[nodiscard]] const std::vector<std::string>& notes() const { return scene_.notes; }
    /// Of its mesh where it is now; what rested did so in the last step.
    [[nodiscard]] Mesh_step quality();

  private:
    void read_mesh();

    int threads_;
    Nodt_scene scene_;
    Moving guide_;
    Nodt_3 nodt_;
    Mesh_3 mesh_;
    Nodt_memory memory_;
    Nodt_step last_;
    std::size_t axis_ = 0;  // that pictures are cut across
    bool read_ = true;  // mesh_ is where the guide is
    bool cells_changed_ = true;
};

/// A recorded motion, which needs no triangulation: who inserts gets the index that was vacated last, or a new one.
template <class Moving_>
class Guided_replay {
  public:
    using Moving = Moving_;
    static constexpr int d = Moving::dimension_of_space;
    static constexpr const char* step_name = "step";

    /// The frames outlive it.
    explicit Guided_replay(Replayed_frames<d>& frames);
    [[nodiscard]] const std::vector<Coordinates<d>>& points() const { return x_; }
    [[nodiscard]] double spacing() const { return frames_.spacing(); }
    bool next(Timestamp<d>& t);
    [[nodiscard]] bool at_end() { return frames_.at_end(); }
    [[nodiscard]] Picture picture(const Moving& dt, std::string caption) const {
        return picture_of(dt, std::move(caption));
    }

  private:
    Replayed_frames<d>& frames_;
    Frame_points<d> frame_;
    Present present_;
    std::vector<Coordinates<d>> x_;
    std::vector<Index> vacant_;
};

extern template class Guided_replay<Moving_mesh_2>;
extern template class Guided_replay<Moving_mesh_3>;

}  // namespace annulus::cli
