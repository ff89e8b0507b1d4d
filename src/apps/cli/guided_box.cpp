// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/guided_box.h>
#include <apps/cli/stopwatch.h>

namespace annulus::inline v1::cli {

template <int d>
Guided_boxed_lloyd<d>::Guided_boxed_lloyd(const Lloyd_arguments& arguments, const std::string& box,
                                          const Common_arguments& common)
    : scene_(Boxed_scene<d>::made_of(arguments, box, common.seed)),
      guide_(scene_.mesh({.threads = common.threads})),
      threads_(common.threads) {
    common.say_merged(arguments.input, scene_.merged);
    if (scene_.file) common.say_notes(scene_.file->notes);
}

template <int d>
bool Guided_boxed_lloyd<d>::next(Boxed_step<d>& t) {
    const Stopwatch watch(threads_);
    t.way = find_centroids<d>(guide_.mesh(), t.x);
    t.id = scene_.ids();
    t.box = scene_.box;
    (void)guide_.follow(t.id, t.x, *t.box);
    t.seconds = watch.seconds();
    return true;
}

template <int d>
Guided_boxed_replay<d>::Guided_boxed_replay(Replayed_frames<d>& frames) : frames_(frames), guide_(first_frame()) {}

template <int d>
auto Guided_boxed_replay<d>::first_frame() -> Moving {
    (void)frames_.next(frame_);
    first_ = {.id = frame_.id, .x = frame_.x, .box = frames_.box()};
    return frames_.with_faults(frame_, [&] { return start({}); });
}

template <int d>
bool Guided_boxed_replay<d>::next(Boxed_step<d>& t) {
    if (!frames_.next(frame_)) return false;
    frames_.with_faults(frame_, [&] { return guide_.follow(frame_.id, frame_.x, frames_.box()); });
    t.id = frame_.id;
    t.x = frame_.x;
    t.box = frames_.box();
    t.way = {guide_.path().mean(), guide_.path().max()};
    return true;
}

template class Guided_boxed_lloyd<2>;
template class Guided_boxed_lloyd<3>;
template class Guided_boxed_replay<2>;
template class Guided_boxed_replay<3>;

}  // namespace annulus::inline v1::cli
