// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/types.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace bench {

using annulus::Index;

template <int d>
using Points = std::vector<annulus::Coordinates<d>>;

/// Points from time step to time step. Their indices are those of Moving_delaunay: the first ones 0, 1, 2 ..; a point
/// that leaves frees its index, and one that arrives gets the index freed last. A time step is removals, one move_all
/// to `points`, insertions.
template <int d>
class Motion {
  public:
    virtual ~Motion() = default;
    Motion() = default;
    Motion(const Motion&) = delete;
    Motion& operator=(const Motion&) = delete;

    /// Advances to the next time step; false when there is none.
    bool step() {
        settle_arrivals();
        before_ = x_;
        return advance();
    }
    /// By index; arriving points are not among them yet, and positions at free indices are ignored.
    [[nodiscard]] const Points<d>& points() const { return x_; }
    [[nodiscard]] std::span<const Index> leave() const { return leave_; }
    [[nodiscard]] std::span<const annulus::Coordinates<d>> arrive() const { return arrive_; }
    /// The index of the k-th point that arrives in this time step.
    [[nodiscard]] Index number_of_arrival(std::size_t k) const {
        const std::size_t free_count = free_indices_.size() + leave_.size();
        if (k >= free_count) return static_cast<Index>(x_.size() + k - free_count);
        return k < leave_.size() ? leave_[leave_.size() - 1 - k] : free_indices_[free_count - 1 - k];
    }
    /// All points that exist after the time step.
    [[nodiscard]] Points<d> present() const {
        Points<d> all;
        all.reserve(x_.size() + arrive_.size());
        for (std::size_t i = 0; i < x_.size(); ++i)
            if (is_there(i)) all.push_back(x_[i]);
        all.insert(all.end(), arrive_.begin(), arrive_.end());
        return all;
    }
    /// Over the points that exist before and after the step, in spacings.
    [[nodiscard]] double mean_displacement() const {
        double sum = 0.0;
        std::size_t count = 0;
        for (std::size_t i = 0; i < x_.size(); ++i) {
            if (!is_there(i)) continue;
            double square = 0.0;
            for (std::size_t k = 0; k < d; ++k) square += (x_[i][k] - before_[i][k]) * (x_[i][k] - before_[i][k]);
            sum += std::sqrt(square);
            ++count;
        }
        return count == 0 ? 0.0 : sum / static_cast<double>(count) / spacing_;
    }

  protected:
    /// Changes x_, calls `leaves` and `arrives`; false when there is no further time step.
    virtual bool advance() = 0;
    void start(Points<d> x, double spacing) {
        x_ = std::move(x);
        there_.assign(x_.size(), 1);
        spacing_ = spacing;
    }
    void leaves(Index i) {
        there_[static_cast<std::size_t>(i)] = 0;
        leave_.push_back(i);
    }
    void arrives(const annulus::Coordinates<d>& p) { arrive_.push_back(p); }
    [[nodiscard]] bool is_there(std::size_t i) const { return there_[i] != 0; }

    Points<d> x_;

  private:
    void settle_arrivals() {
        std::vector<Index> numbers(arrive_.size());
        for (std::size_t k = 0; k < arrive_.size(); ++k) numbers[k] = number_of_arrival(k);
        free_indices_.insert(free_indices_.end(), leave_.begin(), leave_.end());
        free_indices_.resize(free_indices_.size() - std::min(free_indices_.size(), numbers.size()));
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            const auto i = static_cast<std::size_t>(numbers[k]);
            if (i == x_.size()) {
                x_.emplace_back();
                there_.push_back(0);
            }
            x_[i] = arrive_[k];
            there_[i] = 1;
        }
        leave_.clear();
        arrive_.clear();
    }

    Points<d> before_;
    std::vector<char> there_;
    std::vector<Index> free_indices_;  // the last one is reused first
    std::vector<Index> leave_;
    Points<d> arrive_;
    double spacing_ = 1.0;
};

}  // namespace bench
