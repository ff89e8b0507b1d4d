// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/arithmetic/coordinates.h>

#include <span>
#include <vector>

namespace annulus {

/// How far vertices have gone since their spatial sort, beside how far it is from one to the next: by some of them.
template <int d>
class Order_age {
  public:
    /// They are sorted now.
    void note(std::span<const Index> order, std::span<const Coordinates<d>> x);
    /// This one no longer counts. O(1).
    void forget(Index i) noexcept {
        std::erase_if(noted_, [i](const Noted& one) { return one.vertex == i; });
    }
    /// They have gone farther than it is to the next, in the mean of squares. O(1).
    [[nodiscard]] bool is_stale(std::span<const Coordinates<d>> x) const;

  private:
    struct Noted {
        Index vertex;
        Coordinates<d> position;
        double gap;  // squared
    };
    std::vector<Noted> noted_;
};

extern template class Order_age<2>;
extern template class Order_age<3>;

}  // namespace annulus
