// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_set>

namespace annulus::python {

/// A set of positions. -0 and 0 are equal.
template <int d>
class Point_set {
  public:
    explicit Point_set(std::span<const Coordinates<d>> points) {
        places_.reserve(points.size());
        for (const auto& p : points) places_.insert(p);
    }
    /// False if the position was in the set already.
    bool add(const Coordinates<d>& p) { return places_.insert(p).second; }
    [[nodiscard]] std::size_t size() const { return places_.size(); }
    [[nodiscard]] bool has(const Coordinates<d>& p) const { return places_.contains(p); }

  private:
    struct Hash {
        std::size_t operator()(const Coordinates<d>& p) const {
            std::uint64_t h = 0;
            for (const double c : p) {
                h = (h ^ std::bit_cast<std::uint64_t>(c == 0 ? 0.0 : c)) * 0x9e3779b97f4a7c15U;
                h ^= h >> 32;
            }
            return static_cast<std::size_t>(h);
        }
    };
    std::unordered_set<Coordinates<d>, Hash> places_;
};

}  // namespace annulus::python
