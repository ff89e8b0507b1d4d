// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/frame_change.h>
#include <apps/cli/replay_scene.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1::cli {

Motion_options Replay_arguments::motion() const {
    return {absent == "empty"  ? Absent_frames::empty
            : absent == "skip" ? Absent_frames::skip
                               : Absent_frames::refuse,
            format,
            {.taken = boxed && !open && box.empty(), .replaced = !box.empty(), .ignored = open},
            parse_column_choice(columns)};
}

void add_replay(CLI::App& app, Replay_arguments& a) {
    app.add_option(
           "FILE", a.file,
           "Frames: .xyz (extended XYZ), .lammpstrj (LAMMPS dump), .csv, .tsv, .txt or .dat (a table with columns\n"
           "frame, id, x, y [, z], or those of a tracking program) or .npy; each may be compressed, .gz; - is\n"
           "standard input")
        ->required();
    add_format(app, a.format, frame_formats);
    add_columns(app, a.columns);
    app.add_option("--dim", a.dimension, "Dimension; 2 drops z. Without it, 3 if z is not the same everywhere")
        ->check(whole_number(2, 3));
    app.add_option("--coincident", a.coincident,
                   "Duplicate points in a frame: refuse them, or merge: the one with the least id represents all")
        ->check(CLI::IsMember({"refuse", "merge"}))
        ->capture_default_str();
    app.add_option("--absent-frames", a.absent,
                   "Gaps in the frame numbers of a table: refuse them, empty: all points disappear for one step\n"
                   "and appear again, or skip: one step spans the gap, and times may be any distance apart")
        ->check(CLI::IsMember({"refuse", "empty", "skip"}))
        ->capture_default_str();
    add_open(app, a.open);
}

void add_box(CLI::App& app, std::string& box) {
    app.get_option("--open")->description(
        "Ignore the periodic box of a file: points are taken as they are, with open boundaries");
    app.add_option("--box", box,
                   "Periodic box, in place of that of the file: the lengths of its edges, Lx,Ly or Lx,Ly,Lz, or its\n"
                   "vectors, 4 or 9 numbers, one vector after the other")
        ->type_name("LIST");
}

Opened_motion open_motion(const Replay_arguments& a) {
    Opened_motion motion{{}, Motion_reader(a.file, a.motion())};
    static_cast<Motion_start&>(motion) = start_motion(motion.reader, a.file, a.motion(), a.dimension);
    if (a.dimension == 3 && !motion.reader.has_z())
        throw Input_error(Error_code::bad_input, motion.reader.name(), 0, "points have no z",
                          "a third coordinate for --dim 3");
    if (a.dimension == 2 && motion.reader.has_z()) motion.why = "--dim 2 drops z";
    motion.periodic =
        !a.box.empty() || (motion.first.box && is_periodic(*motion.first.box, motion.dimension, motion.reader.name()));
    return motion;
}

Input_record Opened_motion::input() const {
    Input_record input = input_of(reader, dimension);
    input.dimension = why;
    return input;
}

template <int d>
Replayed_frames<d>::Replayed_frames(Opened_motion& motion, const Replay_arguments& arguments)
    : reader_(motion.reader),
      frame_(std::move(motion.first)),
      boxes_(motion.periodic, arguments.box),
      empty_(motion.empty.begin(), motion.empty.end()),
      coincident_(arguments.on_coincident()),
      first_(points_of<d>(reader_.name(), frame_, coincident_, reader_.ids())),
      spacing_(spacing_of<d>(first_->x)) {
    if (d == 2 && arguments.dimension == 0 && reader_.has_z()) z_ = frame_.position.front()[2];
    require_flat();
    boxes_.take(frame_, reader_.name());
    if (!boxes_.periodic()) return;
    first_box_ = box().vectors();
    merge(*first_);
    spacing_ = std::pow(box().volume() / static_cast<double>(std::max<std::size_t>(first_->x.size(), 1)), 1.0 / d);
}

template <int d>
Input_record Replayed_frames<d>::input(const Opened_motion& motion) const {
    Input_record result = motion.input();
    if (!boxes_.periodic()) return result;
    result.box_from = boxes_.what();
    for (const auto& vector : box().vectors()) result.box.emplace_back(vector.begin(), vector.end());
    for (const auto& vector : first_box_)
        if (box_changes_) result.box_before.emplace_back(vector.begin(), vector.end());
    return result;
}

template <int d>
void Replayed_frames<d>::fail(const Error& error, const Frame_points<d>& points) const {
    std::vector<std::size_t> places;  // in the frame as it was read
    std::string ids;
    for (const std::int64_t v : error.vertices()) {
        const std::uint64_t id = points.id[static_cast<std::size_t>(v)];
        places.push_back(
            static_cast<std::size_t>(std::lower_bound(frame_.id.begin(), frame_.id.end(), id) - frame_.id.begin()));
        ids += (ids.empty() ? "" : ids.size() > 60 ? "," : ", ") + reader_.ids().text(id);
        if (places.size() == 8) break;
    }
    const bool duplicate = error.code() == Error_code::duplicate_point;
    const std::string frame = "in frame " + std::to_string(points.number) + " ";
    throw Input_error(error.code(), reader_.name(), frame_.line[places.front()],
                      duplicate ? frame + "the points of ids " + ids + " are at one place of the periodic box"
                                : frame + "the point of id " + ids + ": " + error.what(),
                      duplicate ? "points that differ, or --coincident merge" : "a point nearer to the box");
}

/// Checks the z of later frames of a file that was taken for a 2D motion because of its first frame.
template <int d>
void Replayed_frames<d>::require_flat() const {
    for (std::size_t i = 0; z_ && i < frame_.position.size(); ++i)
        if (frame_.position[i][2] != *z_)
            throw Input_error(Error_code::bad_input, reader_.name(), frame_.line[i],
                              "z is not that of all points before", "--dim 3, or --dim 2 to drop z");
}

template <int d>
bool Replayed_frames<d>::at_end() {
    return empty_.empty() && !first_ && reader_.at_end();
}

template <int d>
bool Replayed_frames<d>::next(Frame_points<d>& frame) {
    if (!empty_.empty()) {
        frame = {.number = empty_.front()};
        empty_.pop_front();
    } else if (first_) {
        frame = std::move(*first_);
        first_.reset();
    } else {
        if (!reader_.next(frame_)) return false;
        require_flat();
        boxes_.take(frame_, reader_.name());
        box_changes_ = box_changes_ || (boxes_.periodic() && box().vectors() != first_box_);
        frame = points_of<d>(reader_.name(), frame_, coincident_, reader_.ids());
        merge(frame);
    }
    return true;
}

/// Points that are images of one another, where coincident ones are to be merged.
template <int d>
void Replayed_frames<d>::merge(Frame_points<d>& points) const {
    if (boxes_.periodic() && coincident_ == Coincident::merge && !points.x.empty())
        with_faults(points, [&] { merge_images(points, box()); });
}

template class Replayed_frames<2>;
template class Replayed_frames<3>;

}  // namespace annulus::inline v1::cli
