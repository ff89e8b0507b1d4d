// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/motion/voxel_marks.h>

#include <algorithm>
#include <cmath>

namespace annulus::inline v1 {

Voxel_marks::Voxel_marks(const Domain_3::Box& box, std::size_t voxels) : box_(box) {
    double longest = 0, product = 1;
    for (std::size_t k = 0; k < 3; ++k) longest = std::max(longest, box.upper[k] - box.lower[k]);
    // A layer around the box keeps the surface off the border of the grid; flat boxes get some thickness.
    for (std::size_t k = 0; k < 3; ++k) {
        const double middle = 0.5 * (box.lower[k] + box.upper[k]);
        const double half = 0.5 * std::max(box.upper[k] - box.lower[k], 0.01 * longest) + 0.01 * longest;
        box_.lower[k] = middle - half;
        box_.upper[k] = middle + half;
        product *= 2 * half / longest;
    }
    edge_ = longest * std::cbrt(product / static_cast<double>(voxels));
    per_edge_ = 1.0 / edge_;
    slack_ = 1e-6 * edge_;
    for (std::size_t k = 0; k < 3; ++k)
        slack_ = std::max({slack_, 1e-15 * std::abs(box_.lower[k]), 1e-15 * std::abs(box_.upper[k])});
    for (std::size_t k = 0; k < 3; ++k)
        size_[k] = static_cast<std::size_t>(std::ceil((box_.upper[k] - box_.lower[k]) / edge_)) + 1;
    for (std::size_t k = 0; k < 3; ++k) last_[k] = static_cast<double>(size_[k] - 1);
    fine_.resize(size_);
    coarse_.resize({(size_[0] + 3) / 4, (size_[1] + 3) / 4, (size_[2] + 3) / 4});
}

std::size_t Voxel_marks::along(double x, std::size_t k) const {
    const double at = (x - box_.lower[k]) * per_edge_;  // rounded towards 0 below, which is down: what is below 0 is 0
    return static_cast<std::size_t>(
        static_cast<std::int64_t>(std::clamp(at, 0.0, last_[k])));  // signed: one instruction
}

Domain_3::Box Voxel_marks::box(const std::array<std::size_t, 3>& at) const {
    // `along` errs by a few roundings of (x - lower) times 1 / edge, which is below the number of voxels of an axis:
    // much less than 1e-6 of an edge. What is computed here is rounded where it is, by 2^-52 of that at most.
    Domain_3::Box b;
    for (std::size_t k = 0; k < 3; ++k) {
        b.lower[k] = box_.lower[k] + static_cast<double>(at[k]) * edge_ - slack_;
        b.upper[k] = box_.lower[k] + static_cast<double>(at[k] + 1) * edge_ + slack_;
    }
    return b;
}

std::array<std::array<std::size_t, 2>, 3> Voxel_marks::range(const Domain_3::Box& b) const {
    std::array<std::array<std::size_t, 2>, 3> r;
    for (std::size_t k = 0; k < 3; ++k) r[k] = {along(b.lower[k] - 10 * slack_, k), along(b.upper[k] + 10 * slack_, k)};
    return r;
}

void Voxel_marks::fill(const std::function<bool(const Coordinates<3>&)>& contains) {
    std::vector<std::size_t> stack;
    const std::size_t step[3] = {1, size_[0], size_[0] * size_[1]};
    for (std::size_t start = 0; start < fine_.count(); ++start) {
        if (fine_[start] != Mark::unknown) continue;
        const std::size_t at[3] = {start % size_[0], start / size_[0] % size_[1], start / step[2]};
        Coordinates<3> middle;
        for (std::size_t k = 0; k < 3; ++k) middle[k] = box_.lower[k] + (static_cast<double>(at[k]) + 0.5) * edge_;
        const Mark side = contains(middle) ? Mark::inside : Mark::outside;
        fine_.set(start, side);
        stack.push_back(start);
        while (!stack.empty()) {
            const std::size_t v = stack.back();
            stack.pop_back();
            const std::size_t i[3] = {v % size_[0], v / size_[0] % size_[1], v / step[2]};
            for (std::size_t k = 0; k < 3; ++k) {
                if (i[k] > 0 && fine_[v - step[k]] == Mark::unknown)
                    fine_.set(v - step[k], side), stack.push_back(v - step[k]);
                if (i[k] + 1 < size_[k] && fine_[v + step[k]] == Mark::unknown)
                    fine_.set(v + step[k], side), stack.push_back(v + step[k]);
            }
        }
    }
    sum_up();
}

void Voxel_marks::sum_up() {
    std::array<std::size_t, 3> at;
    for (at[2] = 0; at[2] < size_[2]; ++at[2])
        for (at[1] = 0; at[1] < size_[1]; ++at[1])
            for (at[0] = 0; at[0] < size_[0]; ++at[0]) {
                const std::size_t cube = coarse_.index({at[0] / 4, at[1] / 4, at[2] / 4});
                const bool first = at[0] % 4 == 0 && at[1] % 4 == 0 && at[2] % 4 == 0;
                const Mark mark = fine_[fine_.index(at)];
                coarse_.set(cube, first || coarse_[cube] == mark ? mark : Mark::near);
            }
}

Voxel_marks::Mark Voxel_marks::of(const Coordinates<3>& p) const {
    std::array<std::size_t, 3> at;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(p[k] > box_.lower[k] && p[k] < box_.upper[k])) return Mark::outside;
        at[k] = along(p[k], k);
    }
    const Mark all = coarse_[coarse_.index({at[0] / 4, at[1] / 4, at[2] / 4})];
    return all != Mark::near ? all : fine_[fine_.index(at)];
}

}  // namespace annulus::inline v1
