// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/sample.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace annulus {

/// Prices in cells looked at (Signs::look_at), measured: bench/README.md.
template <int d>
struct Repair_prices;
template <>
struct Repair_prices<2> {
    static constexpr double rebuild = 20.0;  // a vertex
    static constexpr double cells = 2.0;     // a vertex
    static constexpr double violated = 7.0;
    static constexpr double inverted = 60.0;
    static constexpr double unclear = 20.0;
    static constexpr double mirror = 5.0;  // a vertex
    static constexpr double failure = 7.0;  // of a tolerance
    static constexpr double evaluation = 11.0;
    static constexpr double settling = 15.0;  // a vertex
};
template <>
struct Repair_prices<3> {
    static constexpr double rebuild = 57.0;
    static constexpr double cells = 6.75;
    static constexpr double violated = 10.0;
    static constexpr double inverted = 200.0;
    static constexpr double unclear = 20.0;
    static constexpr double mirror = 10.0;
    static constexpr double failure = 23.0;
    static constexpr double evaluation = 5.7;
    static constexpr double settling = 69.0;
};

/// Whether `auto` rebuilds a timestamp or mends it: by what a few cells say before, what repair cost, and how it ended. No
/// clock has a say in it, nor has it one in what is right.
template <int d>
class Chooser {
  public:
    /// Of a rebuild.
    [[nodiscard]] static double rebuild_price(std::size_t vertices) {
        return Repair_prices<d>::rebuild * static_cast<double>(vertices);
    }
    /// What repair may cost before a rebuild is the better choice: with both, no step costs more than one and a half.
    [[nodiscard]] static double most_repair(std::size_t vertices) { return least + 0.45 * rebuild_price(vertices); }

    /// While every step is a rebuild: whether the next is to be mended, as far as these cells tell.
    [[nodiscard]] bool mends(const Sample& sample) {
        if (wait_ > 0) {
            --wait_;
            return false;
        }
        if (sample.cells == 0) return true;
        using Prices = Repair_prices<d>;
        const double a_cell = Prices::violated * 0.5 * static_cast<double>(sample.violated) +
                              Prices::inverted * static_cast<double>(sample.inverted) +
                              Prices::unclear * static_cast<double>(sample.unclear);
        const double a_vertex = Prices::cells * (1.0 + a_cell / static_cast<double>(sample.cells));
        return a_vertex < 0.4 * Prices::rebuild;
    }
    /// A step was mended.
    void mended() { patience_ = std::max(patience_ / 2, std::uint32_t{1}); }
    /// Repair gave up: it is not tried again for a while, the longer the oftener that happens.
    void gave_up() {
        wait_ = patience_;
        patience_ = std::min(2 * patience_, longest_wait);
    }

  private:
    static constexpr double least = 2000.0;
    static constexpr std::uint32_t longest_wait = 64;
    std::uint32_t wait_ = 0;
    std::uint32_t patience_ = 1;
};

}  // namespace annulus
