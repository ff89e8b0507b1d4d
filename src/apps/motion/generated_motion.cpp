// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/boxed_points.h>
#include <apps/motion/generated_motion.h>

#include <cmath>
#include <utility>

namespace annulus::inline v1 {

namespace {

/// Whether a vector became shorter.
template <int d>
bool shorten(Coordinates<d>& a, const Coordinates<d>& b) {
    double product = 0, square = 0;
    for (std::size_t k = 0; k < d; ++k) {
        product += a[k] * b[k];
        square += b[k] * b[k];
    }
    const double times = std::round(product / square);
    if (std::fabs(product) <= 0.5001 * square || times == 0) return false;  // not to and fro at a half
    for (std::size_t k = 0; k < d; ++k) a[k] -= times * b[k];
    return true;
}

/// The box after x grows by `strain` times y, by vectors that no other one shortens.
template <int d>
Box<d> sheared(const Box<d>& box, double strain) {
    typename Box<d>::Vectors vectors = box.vectors();
    for (auto& v : vectors) v[0] += strain * v[1];
    bool again = true;
    while (again) {
        again = false;
        for (std::size_t i = 0; i < d; ++i)
            for (std::size_t j = 0; j < d; ++j)
                if (i != j && shorten<d>(vectors[i], vectors[j])) again = true;
    }
    return Box<d>(vectors);
}

}  // namespace

template <int d>
Generated_motion<d>::Generated_motion(std::vector<Coordinates<d>> points, Motion_family family, double pace,
                                      std::uint64_t seed)
    : points_(std::move(points)),
      family_(family),
      spacing_(1 / static_cast<double>(grid_side<d>(points_.size()))),
      pace_(pace),
      random_(seed + 1) {  // not the numbers that the points are made of
    if (family_ == Motion_family::orbit) start_orbits();
}

template <int d>
Generated_motion<d>::Generated_motion(const Box<d>& box, std::vector<Coordinates<d>> points, Motion_family family,
                                      double pace, std::uint64_t seed)
    : box_(box),
      points_(std::move(points)),
      family_(family),
      spacing_(spacing_in(box, points_.size())),
      pace_(pace),
      random_(seed + 1) {
    if (family_ == Motion_family::orbit) start_orbits();
}

template <int d>
void Generated_motion<d>::start_orbits() {
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
        case Motion_family::shear: shear(); break;
        case Motion_family::orbit: orbit();
    }
}

template <int d>
void Generated_motion<d>::shear() {
    const double strain = pace_ * spacing_ / (box_ ? spacing_in(*box_, 1) : 1);
    for (auto& p : points_) p[0] += strain * p[1];
    if (box_) box_ = sheared(*box_, strain);
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
