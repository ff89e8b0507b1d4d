// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/generated_motion.h>

#include <cmath>
#include <utility>

namespace annulus::inline v1 {

template <int d>
Generated_motion<d>::Generated_motion(std::vector<Coordinates<d>> points, Motion_family family, double pace,
                                      std::uint64_t seed)
    : points_(std::move(points)),
      family_(family),
      spacing_(1 / static_cast<double>(grid_side<d>(points_.size()))),
      pace_(pace),
      random_(seed + 1) {  // not the numbers that the points are made of
    if (family_ != Motion_family::orbit) return;
    arm_.resize(points_.size());
    for (auto& arm : arm_) {
        double square = 0;
        do {
            arm = {2 * random_.unit() - 1, 2 * random_.unit() - 1};
            square = arm[0] * arm[0] + arm[1] * arm[1];
        } while (square > 1 || square < 0.01);
        for (double& c : arm) c *= 0.5 * spacing_ / std::sqrt(square);
    }
}

template <int d>
void Generated_motion<d>::step() {
    switch (family_) {
        case Motion_family::walk:
            for (auto& p : points_)
                for (double& c : p) c += pace_ * spacing_ * random_.bell();
            break;
        case Motion_family::shear:
            for (auto& p : points_) p[0] += pace_ * spacing_ * p[1];
            break;
        case Motion_family::orbit: orbit();
    }
}

/// Turns each arm by an angle whose half has the tangent `pace`: a rotation of rational numbers. In 3D the orbits lie
/// in planes spanned by two axes, in turn.
template <int d>
void Generated_motion<d>::orbit() {
    const double cosine = (1 - pace_ * pace_) / (1 + pace_ * pace_), sine = 2 * pace_ / (1 + pace_ * pace_);
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const double s = i % 2 == 0 ? sine : -sine;
        const Coordinates<2> arm = arm_[i];
        arm_[i] = {cosine * arm[0] - s * arm[1], s * arm[0] + cosine * arm[1]};
        const std::size_t first = d == 2 ? 0 : i % 3;
        points_[i][first] += arm_[i][0] - arm[0];
        points_[i][(first + 1) % d] += arm_[i][1] - arm[1];
    }
}

template class Generated_motion<2>;
template class Generated_motion<3>;

}  // namespace annulus::inline v1
