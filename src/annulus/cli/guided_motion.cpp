// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/cli/guided_motion.h>
#include <annulus/cli/stopwatch.h>

#include <numeric>
#include <utility>

namespace annulus::cli {

Guided_lloyd::Guided_lloyd(const Lloyd_arguments& arguments, const Common_arguments& common)
    : scene_(make_scene(arguments, common.seed)),
      guide_(scene_.points),
      lloyd_(scene_.domain, scene_.density, common.threads) {
    common.say_merged(arguments.input, scene_.merged);
    common.say_notes(scene_.input.warnings);
}

bool Guided_lloyd::next(Timestamp<2>& t) {
    const auto start = Clock::now();
    t.x.resize(scene_.points.size());
    if (cells_changed_) read_stars(guide_, stars_);
    const Lloyd_step step = lloyd_.step(stars_, guide_.points(), t.x, memory_);
    cells_changed_ = changes_cells(guide_.move_all(std::span<const Coordinates<2>>(t.x)));
    t.way = {step.mean_displacement, step.max_displacement};
    t.seconds = since(start);
    return true;
}

Picture Guided_lloyd::picture(const Moving& dt, std::string caption) const {
    return picture_of(dt, std::move(caption));
}

Guided_nodt::Guided_nodt(const Nodt_arguments& arguments, const Common_arguments& common)
    : threads_(common.threads),
      scene_(make_scene(arguments, common.seed)),
      guide_(scene_.points),
      nodt_(scene_.motion(arguments, common.threads)) {
    mesh_.read(guide_, true, *scene_.domain, threads_);
    scene_.require_cells(arguments, mesh_.inside());
    axis_ = mesh_.shortest_side();
}

bool Guided_nodt::next(Timestamp<3>& t) {
    const auto start = Clock::now();
    t.x.resize(scene_.points.size());
    read_mesh();
    last_ = nodt_.step(mesh_.kept(), mesh_.points(), t.x, memory_);
    cells_changed_ = changes_cells(guide_.move_all(std::span<const Coordinates<3>>(t.x)));
    read_ = false;
    t.way = {last_.mean_displacement, last_.max_displacement};
    t.seconds = since(start);
    return true;
}

void Guided_nodt::read_mesh() {
    if (!read_) mesh_.read(guide_, cells_changed_, *scene_.domain, threads_);
    read_ = true;
}

Mesh_step Guided_nodt::quality() {
    read_mesh();
    return measured(mesh_, last_);
}

Picture Guided_nodt::picture(const Moving& dt, std::string caption) const {
    Mesh_3 mesh;
    mesh.read(dt, true, *scene_.domain, threads_);
    return mesh.cut(std::move(caption), axis_);
}

template <class Moving>
Guided_replay<Moving>::Guided_replay(Replayed_frames<d>& frames) : frames_(frames) {
    (void)frames_.next(frame_);
    x_ = frame_.x;
    present_ = {std::move(frame_.id), std::vector<Index>(x_.size())};
    std::iota(present_.index.begin(), present_.index.end(), Index{0});
}

template <class Moving>
bool Guided_replay<Moving>::next(Timestamp<d>& t) {
    if (!frames_.next(frame_)) return false;
    Frame_change<d> change(present_, x_, frame_);
    t.leave = std::move(change.leave);
    t.x = std::move(change.x);
    t.arrive = std::move(change.arrive);
    t.way = {change.mean(), change.max};
    x_ = t.x;
    vacant_.insert(vacant_.end(), t.leave.begin(), t.leave.end());
    auto arriving = t.arrive.begin();
    for (Index& index : change.index) {
        if (index != none) continue;
        index = static_cast<Index>(x_.size());
        if (vacant_.empty()) {
            x_.emplace_back();
        } else {
            index = vacant_.back();
            vacant_.pop_back();
        }
        x_[static_cast<std::size_t>(index)] = *arriving++;
    }
    present_ = {std::move(frame_.id), std::move(change.index)};
    return true;
}

template class Guided_replay<Moving_mesh_2>;
template class Guided_replay<Moving_mesh_3>;

}  // namespace annulus::cli
