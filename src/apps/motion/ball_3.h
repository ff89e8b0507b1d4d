// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/domain_3.h>

namespace annulus::inline v1 {

/// The ball with its centre at the origin.
class Ball_3 final : public Domain_3 {
  public:
    /// Throws Error(usage) unless 1e-100 <= radius <= 1e100.
    explicit Ball_3(double radius);

    [[nodiscard]] bool contains(const Coordinates<3>& p) const override;
    using Domain_3::project;
    [[nodiscard]] Coordinates<3> project(const Coordinates<3>& p) const override;
    [[nodiscard]] std::optional<Coordinates<3>> crossing(const Coordinates<3>& a,
                                                         const Coordinates<3>& b) const override;
    [[nodiscard]] std::vector<Coordinates<3>> surface_sample(std::size_t n, std::uint64_t seed) const override;
    [[nodiscard]] Box bounding_box() const override;
    [[nodiscard]] double volume() const override;

  private:
    double radius_;
};

}  // namespace annulus::inline v1
