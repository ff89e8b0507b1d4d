// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/frame_follower.h>
#include <apps/report/axis_ticks.h>

#include <algorithm>
#include <iterator>
#include <numeric>
#include <utility>

namespace annulus::inline v1::cli {

std::string Traffic::in_words() const {
    std::string text = grouped(arrived, "point") + " appeared, " + grouped(left) + " disappeared";
    if (merged > 0) text += ", " + grouped(merged) + " merged with others at their place";
    return text + ".";
}

template <int d>
void Frame_follower<Moving_mesh<d>>::begin(Frame_points<d>& frame, Frame_files<Moving>* files) {
    present_ = {std::move(frame.id), std::vector<Index>(frame.x.size())};
    std::iota(present_.index.begin(), present_.index.end(), Index{0});
    for (std::size_t k = 0; files != nullptr && k < present_.id.size(); ++k)
        files->name(present_.index[k], present_.id[k]);
}

template <int d>
void Frame_follower<Moving_mesh<d>>::step(Follows& tracker, Frame_points<d>& frame, Frame_files<Moving>* files,
                                          Traffic& traffic) {
    Frame_change<d> change(present_, tracker.triangulation().points(), frame);
    if (files != nullptr) {
        std::vector<std::uint64_t> ids;
        for (std::size_t k = 0; k < change.index.size(); ++k)
            if (change.index[k] == none) ids.push_back(frame.id[k]);
        files->arriving(ids);
    }
    const auto indices = tracker.follow(change.leave, change.x, change.arrive, 0, change.mean(), change.max);
    auto arrived = indices.begin();
    for (Index& index : change.index)
        if (index == none) index = *arrived++;
    present_ = {std::move(frame.id), std::move(change.index)};
    traffic.arrived += indices.size();
    traffic.left += change.leave.size();
}

namespace {

/// The number of elements of `a` that are not in `b`; both ascend.
std::uint64_t missing(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b) {
    std::vector<std::uint64_t> result;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(result));
    return result.size();
}

}  // namespace

template <int d>
std::function<Boxed_mesh<d>()> Frame_follower<Boxed_mesh<d>>::make(const Frame_points<d>& frame,
                                                                   const Options& options) const {
    return [this, &frame, options] {
        return frames_.with_faults(frame, [&] { return Moving(frame.id, frame.x, frames_.box(), options); });
    };
}

template <int d>
void Frame_follower<Boxed_mesh<d>>::begin(Frame_points<d>& frame, Frame_files<Moving>* files) {
    for (std::size_t k = 0; files != nullptr && k < frame.id.size(); ++k)
        files->name(static_cast<Index>(k), frame.id[k]);
}

template <int d>
void Frame_follower<Boxed_mesh<d>>::step(Follows& tracker, Frame_points<d>& frame, Frame_files<Moving>* files,
                                         Traffic& traffic) {
    const auto present = tracker.triangulation().ids();
    traffic.arrived += missing(frame.id, present);
    traffic.left += missing(present, frame.id);
    Displacement way;
    tracker.step(
        [&](Moving& dt) {
            return frames_.with_faults(frame, [&] {
                const Move_result result = dt.follow(frame.id, frame.x, frames_.box());
                way = {dt.path().mean(), dt.path().max()};
                return result;
            });
        },
        0, way);
    begin(frame, files);
}

template class Frame_follower<Moving_mesh<2>>;
template class Frame_follower<Moving_mesh<3>>;
template class Frame_follower<Boxed_mesh<2>>;
template class Frame_follower<Boxed_mesh<3>>;

}  // namespace annulus::inline v1::cli
