// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/circumcentre.h>
#include <annulus/mesh/periodic_table.h>
#include <annulus/space/lattice.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

namespace annulus::inline v1 {

/// The places of images and the circumcentres of cells, relative to their first corners, in a unit in which no
/// coordinate is above 1.
template <int d>
class Periodic_places {
  public:
    Periodic_places(const Periodic_table<d>& table, const Lattice<d>& lattice, std::span<const Coordinates<d>> place)
        : table_(table), lattice_(lattice), place_(place) {
        double largest = 0;
        for (std::size_t i = 0; i < d; ++i) largest = std::max(largest, std::ldexp(lattice.grid()[i], 53));
        exponent_ = std::ilogb(largest);
        centre_.reserve(table.size());
        for (std::size_t c = 0; c < table.size(); ++c) {
            Corners<d> corners;
            for (std::size_t i = 0; i <= d; ++i) corners[i] = at(table.image(c, i));
            centre_.push_back(circumcentre<d>(corners, scale()));
        }
    }

    [[nodiscard]] Coordinates<d> at(Image<d> s) const {
        return lattice_.place(place_[static_cast<std::size_t>(s.vertex)], s.label);
    }
    /// The unit is 2^exponent; multiplying by `scale` gives numbers of it.
    [[nodiscard]] int exponent() const { return exponent_; }
    [[nodiscard]] double scale() const { return std::ldexp(1.0, -exponent_); }
    [[nodiscard]] std::span<const Circumcentre<d>> centres() const { return centre_; }

  private:
    const Periodic_table<d>& table_;
    const Lattice<d>& lattice_;
    std::span<const Coordinates<d>> place_;
    int exponent_ = 0;
    std::vector<Circumcentre<d>> centre_;
};

}  // namespace annulus::inline v1
