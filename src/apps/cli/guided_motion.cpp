// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/guided_motion.h>
#include <apps/cli/stopwatch.h>

#include <numeric>
#include <utility>

namespace annulus::inline v1::cli {

Guided_lloyd::Guided_lloyd(const Lloyd_arguments& arguments, const Common_arguments& common)
    : scene_(make_scene(arguments, common.seed)),
      guide_(scene_.points),
      lloyd_(scene_.domain, scene_.density, common.threads, scene_.border),
      threads_(common.threads) {
    common.say_merged(arguments.input, scene_.merged);
    common.say_notes(scene_.input.warnings);
}

bool Guided_lloyd::next(Time_step<2>& t) {
    const Stopwatch watch(threads_);
    t.x.resize(scene_.points.size());
    if (cells_changed_) read_stars(guide_, stars_);
    const Lloyd_step step = lloyd_.step(stars_, guide_.points(), t.x, memory_);
    cells_changed_ = changes_cells(guide_.move_all(std::span<const Coordinates<2>>(t.x)));
    t.way = {step.mean_displacement, step.max_displacement};
    t.seconds = watch.seconds();
    return true;
}

Picture Guided_lloyd::picture(const Moving& dt, std::string caption) const {
    return picture_of(dt, std::move(caption));
}

template <class Moving>
Guided_replay<Moving>::Guided_replay(Replayed_frames<d>& frames) : frames_(frames) {
    (void)frames_.next(frame_);
    x_ = frame_.x;
    present_ = {std::move(frame_.id), std::vector<Index>(x_.size())};
    std::iota(present_.index.begin(), present_.index.end(), Index{0});
}

template <class Moving>
bool Guided_replay<Moving>::next(Time_step<d>& t) {
    if (!frames_.next(frame_)) return false;
    Frame_change<d> change(present_, x_, frame_);
    t.leave = std::move(change.leave);
    t.x = std::move(change.x);
    t.arrive = std::move(change.arrive);
    t.way = {change.mean(), change.max};
    x_ = t.x;
    free_indices_.insert(free_indices_.end(), t.leave.begin(), t.leave.end());
    auto arriving = t.arrive.begin();
    for (Index& index : change.index) {
        if (index != none) continue;
        index = static_cast<Index>(x_.size());
        if (free_indices_.empty()) {
            x_.emplace_back();
        } else {
            index = free_indices_.back();
            free_indices_.pop_back();
        }
        x_[static_cast<std::size_t>(index)] = *arriving++;
    }
    present_ = {std::move(frame_.id), std::move(change.index)};
    return true;
}

template class Guided_replay<Moving_mesh_2>;
template class Guided_replay<Moving_mesh_3>;

}  // namespace annulus::inline v1::cli
