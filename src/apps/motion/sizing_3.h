// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/domain_3.h>

#include <cmath>

namespace annulus::inline v1 {

/// The target length of edges in a domain, up to a factor: mu(p) = 1 + gradation · dist(p, surface) / r, where r is the
/// radius of the ball of the same volume. Gradation 0 is constant sizing; mu is gradation / r Lipschitz.
class Sizing_3 {
  public:
    explicit Sizing_3(const Domain_3& domain, double gradation = 0)
        : domain_(&domain), slope_(gradation / std::cbrt(0.75 / 3.14159265358979324 * domain.volume())) {}

    [[nodiscard]] bool constant() const { return slope_ == 0; }
    /// At a point of the domain or its surface.
    [[nodiscard]] double at(const Coordinates<3>& p) const {
        if (constant()) return 1;
        const Coordinates<3> q = domain_->project(p);
        return 1 + slope_ * std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
    }

  private:
    const Domain_3* domain_;
    double slope_;
};

}  // namespace annulus::inline v1
