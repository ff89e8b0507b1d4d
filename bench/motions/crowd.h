// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "motion.h"
#include "random.h"

#include <cstdint>
#include <vector>

namespace bench {

/// A crowd: two streams of people that walk against each other through a corridor 20 m wide with columns in its middle,
/// one person on two square metres, by the social forces of Helbing and Molnar (1995) with their constants, integrated
/// 50 times a second. A person who reaches the end leaves, and another arrives at the other end. Time steps are `every`
/// steps of integration apart: with 1 a person moves by about 0.02 spacings, 5 (ten a second) is the rate of cameras,
/// 20 (one each 0.4 s) that of published recordings of streets.
class Crowd : public Motion<2> {
  public:
    Crowd(std::size_t n, int every, std::uint64_t seed);

  private:
    using Point = annulus::Coordinates<2>;

    bool advance() override;
    void integrate();
    void add_repulsions(Points<2>& force) const;
    void add_walls(Points<2>& force) const;
    /// Whether no person is nearer to p than some distance.
    [[nodiscard]] bool is_free(const Point& p) const;
    [[nodiscard]] double wished_speed();

    int every_;
    double length_;
    Random random_;
    Points<2> velocity_;         // by number, as the following members
    std::vector<int> heading_;   // 1 or -1 along the corridor
    std::vector<double> speed_;  // desired
    std::vector<Point> columns_;
};

}  // namespace bench
