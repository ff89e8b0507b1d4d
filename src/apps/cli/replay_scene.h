// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/error.h>
#include <apps/cli/arguments.h>
#include <apps/cli/frame_box.h>
#include <apps/cli/input.h>
#include <apps/formats/frame_points.h>
#include <apps/formats/motion_start.h>

#include <deque>
#include <optional>
#include <string>
#include <vector>

namespace annulus::inline v1::cli {

/// The arguments that say which recorded motion to follow.
struct Replay_arguments {
    std::string file;
    int dimension = 0;  ///< 0: that of the file
    std::string coincident = "refuse";
    std::string absent = "refuse";
    std::string format;     ///< if not that of the extension
    bool open = false;      ///< ignore a periodic box
    std::string columns{};  ///< of a table: "id=particle,frame=t"
    bool boxed = false;     ///< periodic boxes are taken; else refused
    std::string box{};      ///< --box: in place of those of the file

    [[nodiscard]] Coincident on_coincident() const {
        return coincident == "merge" ? Coincident::merge : Coincident::refuse;
    }
    [[nodiscard]] Motion_options motion() const;
};

void add_replay(CLI::App& app, Replay_arguments& arguments);
/// Of a command that takes periodic boxes: --box.
void add_box(CLI::App& app, std::string& box);

/// A motion whose first frames, up to one with points, have been read to find its dimension.
struct Opened_motion : Motion_start {
    Motion_reader reader;
    bool periodic = false;  ///< in all its dimensions

    /// How the file was interpreted, up to where it has been read.
    [[nodiscard]] Input_record input() const;
};
/// Throws Input_error.
[[nodiscard]] Opened_motion open_motion(const Replay_arguments& arguments);

/// The frames of a file as a motion of dimension d.
template <int d>
class Replayed_frames {
  public:
    Replayed_frames(Opened_motion& motion, const Replay_arguments& arguments);

    /// The box of the last frame. Precondition: the motion is periodic.
    [[nodiscard]] const Box<d>& box() const { return boxes_.now(); }
    /// How the file was interpreted, up to where it has been read.
    [[nodiscard]] Input_record input(const Opened_motion& motion) const;
    /// Calls a triangulation of this frame, the last one; its errors name points of the frame.
    template <class Call>
    auto with_faults(const Frame_points<d>& points, Call call) const {
        try {
            return call();
        } catch (const Error& error) {
            if (error.vertices().empty()) throw;
            fail(error, points);
        }
    }
    /// The unit of length: see spacing_of; in a box the d-th root of its volume per point.
    [[nodiscard]] double spacing() const { return spacing_; }
    [[nodiscard]] bool at_end();
    bool next(Frame_points<d>& frame);
    /// The frame of which the last one with points was made: with coincident points.
    [[nodiscard]] const Frame& as_read() const { return frame_; }
    [[nodiscard]] const Motion_reader& reader() const { return reader_; }

  private:
    /// Throws Input_error for an error that names points of this frame, the last one.
    [[noreturn]] void fail(const Error& error, const Frame_points<d>& points) const;
    void require_flat() const;
    void merge(Frame_points<d>& points) const;

    Motion_reader& reader_;
    Frame frame_;
    Frame_boxes<d> boxes_;
    typename Box<d>::Vectors first_box_{};
    bool box_changes_ = false;
    std::deque<std::uint64_t> empty_;
    Coincident coincident_;
    std::optional<Frame_points<d>> first_;
    double spacing_;
    std::optional<double> z_;
};

extern template class Replayed_frames<2>;
extern template class Replayed_frames<3>;

}  // namespace annulus::inline v1::cli
