// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <apps/motion/domain_3.h>

#include <array>
#include <cstdint>
#include <functional>
#include <vector>

namespace annulus::inline v1 {

/// A grid over a box in which every voxel is inside a closed surface, outside, or may meet it.
///
/// Voxels that do not meet the surface and share a side are on the same side of it, so one test decides for all that
/// are connected. A cube of 4 x 4 x 4 voxels that are all inside or all outside has one coarse mark: away from the
/// surface only these few marks are read, and they stay in the cache.
class Voxel_marks {
  public:
    enum class Mark : std::uint8_t { unknown, near, inside, outside };

    /// About `voxels` cubes over `box`, which contains the surface.
    Voxel_marks(const Domain_3::Box& box, std::size_t voxels);

    [[nodiscard]] const std::array<std::size_t, 3>& size() const { return size_; }
    /// The closed voxel with these indices, widened by more than `of` rounds.
    [[nodiscard]] Domain_3::Box box(const std::array<std::size_t, 3>& at) const;
    /// The voxels that a box may meet, as the first and the last index of every axis.
    [[nodiscard]] std::array<std::array<std::size_t, 2>, 3> range(const Domain_3::Box& box) const;
    void set_near(const std::array<std::size_t, 3>& at) { fine_.set(fine_.index(at), Mark::near); }
    /// Marks all other voxels, given an exact test of a point.
    void fill(const std::function<bool(const Coordinates<3>&)>& contains);

    /// Points beyond the box are outside. Never `unknown` after `fill`.
    [[nodiscard]] Mark of(const Coordinates<3>& p) const;

  private:
    /// Two bits a voxel.
    struct Marks {
        std::array<std::size_t, 3> size{};
        std::vector<std::uint8_t> bits;

        void resize(const std::array<std::size_t, 3>& to) {
            size = to;
            bits.assign((count() + 3) / 4, 0);
        }
        [[nodiscard]] std::size_t count() const { return size[0] * size[1] * size[2]; }
        [[nodiscard]] std::size_t index(const std::array<std::size_t, 3>& at) const {
            return (at[2] * size[1] + at[1]) * size[0] + at[0];
        }
        [[nodiscard]] Mark operator[](std::size_t i) const { return static_cast<Mark>(bits[i / 4] >> 2 * (i % 4) & 3); }
        void set(std::size_t i, Mark mark) {
            const auto others = bits[i / 4] & ~(3U << 2 * (i % 4));
            bits[i / 4] = static_cast<std::uint8_t>(others | static_cast<unsigned>(mark) << 2 * (i % 4));
        }
    };

    [[nodiscard]] std::size_t along(double x, std::size_t k) const;
    void sum_up();

    Domain_3::Box box_;
    std::array<std::size_t, 3> size_{};
    std::array<double, 3> last_{};  // indices
    double edge_ = 1;
    double per_edge_ = 1;
    double slack_ = 0;
    Marks fine_, coarse_;  // coarse_: near where the fine ones differ
};

}  // namespace annulus::inline v1
