// SPDX-License-Identifier: GPL-3.0-or-later
#include "recording.h"

#include <apps/formats/frame_points.h>

#include <numeric>

namespace bench {

namespace {

template <int d>
double spacing_of(const Points<d>& x) {
    double volume = 1.0;
    for (std::size_t k = 0; k < d; ++k) {
        const auto [low, high] =
            std::minmax_element(x.begin(), x.end(), [k](const auto& a, const auto& b) { return a[k] < b[k]; });
        volume *= (*high)[k] - (*low)[k];
    }
    return volume > 0.0 ? std::pow(volume / static_cast<double>(x.size()), 1.0 / d) : 1.0;
}

}  // namespace

std::size_t fullest(const annulus::Recorded_motion& recorded) {
    const auto most = std::max_element(recorded.frames.begin(), recorded.frames.end(),
                                       [](const auto& a, const auto& b) { return a.id.size() < b.id.size(); });
    return static_cast<std::size_t>(most - recorded.frames.begin());
}

template <int d>
Recording<d>::Recording(const annulus::Recorded_motion& recorded, std::size_t first_frame)
    : recorded_(recorded), next_(first_frame) {
    annulus::Frame_points<d> first;
    while (first.x.empty() && next_ < recorded_.frames.size())
        first = annulus::points_of<d>(recorded_.name, recorded_.frames[next_++], annulus::Coincident::merge);
    id_ = std::move(first.id);
    number_.resize(id_.size());
    std::iota(number_.begin(), number_.end(), Index{0});
    const double spacing = spacing_of<d>(
        annulus::points_of<d>(recorded_.name, recorded_.frames[fullest(recorded_)], annulus::Coincident::merge).x);
    this->start(std::move(first.x), spacing);
}

template <int d>
bool Recording<d>::advance() {
    if (next_ == recorded_.frames.size()) return false;
    auto frame = annulus::points_of<d>(recorded_.name, recorded_.frames[next_++], annulus::Coincident::merge);
    std::vector<Index> number(frame.id.size(), annulus::none);
    std::size_t p = 0;
    for (std::size_t f = 0; f < frame.id.size(); ++f) {
        while (p < id_.size() && id_[p] < frame.id[f]) this->leaves(number_[p++]);
        if (p == id_.size() || id_[p] != frame.id[f]) {
            this->arrives(frame.x[f]);
            continue;
        }
        number[f] = number_[p++];
        x_[static_cast<std::size_t>(number[f])] = frame.x[f];
    }
    while (p < id_.size()) this->leaves(number_[p++]);
    std::size_t arrival = 0;
    for (Index& i : number)
        if (i == annulus::none) i = this->number_of_arrival(arrival++);
    id_ = std::move(frame.id);
    number_ = std::move(number);
    return true;
}

template class Recording<2>;
template class Recording<3>;

}  // namespace bench
