// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/engine/prices.h>
#include <annulus/engine/sample.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace annulus {

/// Whether `auto` rebuilds a timestamp or mends it: by what a few cells say before, what repair cost, and how it
/// ended. No clock has a say in it, nor has it one in what is right.
template <int d>
class Chooser {
  public:
    [[nodiscard]] static double rebuild_price(std::size_t vertices) {
        return Prices<d>::rebuild * static_cast<double>(vertices);
    }
    /// What repair may cost before it gives up.
    [[nodiscard]] static double most_repair(std::size_t vertices) { return share() * static_cast<double>(vertices); }
    /// The same where no step is promised to cost so little: a few vertices are not rebuilt because they are few.
    [[nodiscard]] static double most_generous_repair(std::size_t vertices) { return 4000.0 + most_repair(vertices); }

    /// What may be done to a part before all is built anew instead.
    [[nodiscard]] static double most_generous_rebuild(std::size_t vertices) { return 4000.0 + rebuild_price(vertices); }
    /// Of vertices that move one by one, `done` of them at a price so far: whether all `movers` are going to cost
    /// more than a rebuild, by what these did. Not before they have cost a part of one, so that they tell something.
    [[nodiscard]] static bool is_too_dear_one_by_one(double price, std::size_t done, std::size_t movers,
                                                     std::size_t vertices) {
        const double rebuild = rebuild_price(vertices);
        return price > rebuild / 8.0 && price / static_cast<double>(done) * static_cast<double>(movers) > rebuild;
    }
    /// The same where a strategy goes one by one: more than such moves cost where what they change is local, and a
    /// rebuild.
    [[nodiscard]] static bool is_too_dear_in_turn(double price, std::size_t done, std::size_t vertices) {
        return price > most_generous_rebuild(vertices) + 4.0 * Prices<d>::reinsertion * static_cast<double>(done);
    }

    /// While every step is a rebuild: no need to ask a larger sample, nor to count how often it was asked.
    [[nodiscard]] bool is_hopeless(const Sample& few) const { return price_of(few) > 3.0 * share(); }
    /// While every step is a rebuild: whether the next is to be mended, as far as these cells tell.
    [[nodiscard]] bool mends(const Sample& sample) {
        const double price = price_of(sample);
        const bool calmer = price < 0.4 * gave_up_at_;
        if (wait_ > 0 && !calmer) {
            --wait_;
            return false;
        }
        wait_ = 0;
        tried_ = price;
        return price < share();
    }
    /// A step was mended.
    void mended() {
        patience_ = std::max(patience_ / 2, std::uint32_t{1});
        tried_ = 0.0;
    }
    /// Repair gave up: it is not tried again for a while, the longer the oftener that happens, unless the motion
    /// becomes calmer.
    void gave_up() {
        gave_up_at_ = tried_;
        wait_ = patience_;
        patience_ = std::min(2 * patience_, longest_wait);
    }

    /// That, a vertex: as much as a rebuild, so that with the one that follows no step costs more than twice what was
    /// the best (rent or buy), which is less than one and a half insertions of all points.
    static constexpr double share() { return Prices<d>::rebuild - (Prices<d>::signs - Prices<d>::cells); }
    static_assert(share() + Prices<d>::rebuild + (Prices<d>::signs - Prices<d>::cells) < 1.45 * Prices<d>::insertion);

  private:
    static constexpr std::uint32_t longest_wait = 64;

    /// A vertex, of mending.
    [[nodiscard]] static double price_of(const Sample& sample) {
        if (sample.cells == 0) return 0.0;
        const double more = Prices<d>::violated * 0.5 * static_cast<double>(sample.violated) +
                            Prices<d>::inverted * static_cast<double>(sample.inverted) +
                            Prices<d>::unclear * static_cast<double>(sample.unclear);
        return Prices<d>::cells * (1.0 + more / static_cast<double>(sample.cells));
    }

    std::uint32_t wait_ = 0;
    std::uint32_t patience_ = 1;
    double tried_ = 0.0;       // what the sample said of the step before the first mended one; 0 once one was mended
    double gave_up_at_ = 0.0;  // what it had said when repair gave up; 0 if others had been mended before
};

}  // namespace annulus
