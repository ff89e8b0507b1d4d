// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/motion/voxel_marks.h>

#include <algorithm>
#include <cmath>

namespace annulus {

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
    for (std::size_t k = 0; k < 3; ++k)
        size_[k] = static_cast<std::size_t>(std::ceil((box_.upper[k] - box_.lower[k]) / edge_)) + 1;
    mark_.assign(size_[0] * size_[1] * size_[2], Mark::unknown);
}

std::size_t Voxel_marks::along(double x, std::size_t k) const {
    const double at = (x - box_.lower[k]) * per_edge_;  // rounded towards 0 below, which is down: what is below 0 is 0
    return static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(size_[k] - 1)));
}

Domain_3::Box Voxel_marks::box(const std::array<std::size_t, 3>& at) const {
    // `along` errs by a few roundings of (x - lower) times 1 / edge, which is below the number of voxels of an axis, so a widening
    // by 1e-6 of an edge is ample unless the box is 1e9 times farther from the origin than an edge is long.
    Domain_3::Box b;
    for (std::size_t k = 0; k < 3; ++k) {
        const double slack = 1e-6 * edge_;
        b.lower[k] = box_.lower[k] + static_cast<double>(at[k]) * edge_ - slack;
        b.upper[k] = box_.lower[k] + static_cast<double>(at[k] + 1) * edge_ + slack;
    }
    return b;
}

std::array<std::array<std::size_t, 2>, 3> Voxel_marks::range(const Domain_3::Box& b) const {
    std::array<std::array<std::size_t, 2>, 3> r;
    const double slack = 1e-5 * edge_;
    for (std::size_t k = 0; k < 3; ++k) r[k] = {along(b.lower[k] - slack, k), along(b.upper[k] + slack, k)};
    return r;
}

void Voxel_marks::fill(const std::function<bool(const Coordinates<3>&)>& contains) {
    std::vector<std::size_t> stack;
    const std::size_t step[3] = {1, size_[0], size_[0] * size_[1]};
    for (std::size_t start = 0; start < mark_.size(); ++start) {
        if (mark_[start] != Mark::unknown) continue;
        const std::size_t at[3] = {start % size_[0], start / size_[0] % size_[1], start / step[2]};
        Coordinates<3> middle;
        for (std::size_t k = 0; k < 3; ++k) middle[k] = box_.lower[k] + (static_cast<double>(at[k]) + 0.5) * edge_;
        const Mark mark = contains(middle) ? Mark::inside : Mark::outside;
        mark_[start] = mark;
        stack.push_back(start);
        while (!stack.empty()) {
            const std::size_t v = stack.back();
            stack.pop_back();
            const std::size_t i[3] = {v % size_[0], v / size_[0] % size_[1], v / step[2]};
            for (std::size_t k = 0; k < 3; ++k) {
                if (i[k] > 0 && mark_[v - step[k]] == Mark::unknown)
                    mark_[v - step[k]] = mark, stack.push_back(v - step[k]);
                if (i[k] + 1 < size_[k] && mark_[v + step[k]] == Mark::unknown)
                    mark_[v + step[k]] = mark, stack.push_back(v + step[k]);
            }
        }
    }
}

Voxel_marks::Mark Voxel_marks::of(const Coordinates<3>& p) const {
    std::array<std::size_t, 3> at;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(p[k] > box_.lower[k] && p[k] < box_.upper[k])) return Mark::outside;
        at[k] = along(p[k], k);
    }
    return mark_[index(at)];
}

}  // namespace annulus
