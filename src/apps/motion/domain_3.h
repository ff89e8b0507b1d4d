// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>
#include <apps/motion/nearby_3.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace annulus::inline v1 {

/// A bounded open set in 3D with a closed surface around it. Immutable; const members may run concurrently.
class Domain_3 {
  public:
    struct Box {
        Coordinates<3> lower{}, upper{};
    };

    Domain_3() = default;
    Domain_3(const Domain_3&) = delete;
    Domain_3& operator=(const Domain_3&) = delete;
    virtual ~Domain_3() = default;

    [[nodiscard]] virtual bool contains(const Coordinates<3>& p) const = 0;
    /// The nearest point of the surface, up to rounding. Precondition: p is finite.
    [[nodiscard]] virtual Coordinates<3> project(const Coordinates<3>& p) const = 0;
    /// The same for queries that are repeated from places that are close together: `near` is a point of the surface, up
    /// to rounding, not far away, and `nearby` is the state kept from earlier queries of this domain. The result is bit
    /// for bit the same whatever these are.
    [[nodiscard]] virtual Coordinates<3> project(const Coordinates<3>& p, const Coordinates<3>& near,
                                                 Nearby_3& nearby) const {
        (void)near, (void)nearby;
        return project(p);
    }
    /// A point of the surface on the segment from a to b, up to rounding; nothing when they do not meet.
    [[nodiscard]] virtual std::optional<Coordinates<3>> crossing(const Coordinates<3>& a,
                                                                 const Coordinates<3>& b) const = 0;
    /// n points of the surface, independent and uniform, the same for the same seed.
    [[nodiscard]] virtual std::vector<Coordinates<3>> surface_sample(std::size_t n, std::uint64_t seed) const = 0;
    [[nodiscard]] virtual Box bounding_box() const = 0;
    [[nodiscard]] virtual double volume() const = 0;
};

}  // namespace annulus::inline v1
