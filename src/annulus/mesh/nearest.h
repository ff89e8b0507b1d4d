// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

namespace annulus::inline v1 {

/// The nearest of the vertices or cells at which a walk may begin; the first of those that are equally near.
template <class Item>
class Nearest {
  public:
    /// `fallback` is the answer where nothing is offered.
    explicit Nearest(Item fallback) : item_(fallback) {}

    /// Whether something at this distance would be taken. All distances are of one kind, squared or not.
    [[nodiscard]] bool takes(double distance) const { return !any_ || distance < distance_; }
    void offer(Item item, double distance) {
        if (!takes(distance)) return;
        any_ = true;
        item_ = item;
        distance_ = distance;
    }
    [[nodiscard]] Item item() const { return item_; }

  private:
    Item item_;
    double distance_ = std::numeric_limits<double>::infinity();
    bool any_ = false;
};

}  // namespace annulus::inline v1
