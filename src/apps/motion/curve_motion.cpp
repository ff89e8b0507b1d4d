// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/curve_motion.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace annulus::inline v1 {

Curve_motion::Curve_motion(std::shared_ptr<const Feature_curves> features, std::vector<Feature_curves::Place> places)
    : features_(std::move(features)), places_(std::move(places)), vertices_(features_->curves().size()) {
    for (std::size_t v = 0; v < places_.size(); ++v)
        if (const auto curve = static_cast<Index>(places_[v]); curve >= 0)
            vertices_[static_cast<std::size_t>(curve)].push_back(static_cast<Index>(v));
}

std::vector<Curve_motion::Target_on_curve> Curve_motion::wishes(std::span<const Coordinates<3>> position) const {
    std::vector<Target_on_curve> all;
    for (std::size_t c = 0; c < vertices_.size(); ++c) {
        const Polyline_3& curve = features_->curves()[c];
        const std::size_t first = all.size();
        for (const Index v : vertices_[c]) {
            const double at = curve.nearest(position[static_cast<std::size_t>(v)]);
            all.push_back({v, static_cast<Index>(c), at, at});
        }
        const std::span<Target_on_curve> here = std::span(all).subspan(first);
        std::sort(here.begin(), here.end(), [](const Target_on_curve& a, const Target_on_curve& b) {
            return a.at != b.at ? a.at < b.at : a.vertex < b.vertex;
        });
        for (std::size_t i = 0; i < here.size(); ++i) {
            const double around = features_->goes_around(c) ? curve.length() : 0;
            const double before = i > 0 ? here[i - 1].at : around > 0 ? here.back().at - around : 0;
            const double after = i + 1 < here.size() ? here[i + 1].at
                                 : around > 0        ? here.front().at + around
                                                     : curve.length();
            here[i].wanted = before + 0.5 * (after - before);
        }
    }
    return all;
}

Coordinates<3> Curve_motion::place(const Target_on_curve& target, double share, double most) const {
    const double way = target.wanted - target.at;
    return features_->curves()[static_cast<std::size_t>(target.curve)].at(target.at +
                                                                          std::clamp(share * way, -most, most));
}

}  // namespace annulus::inline v1
