// SPDX-License-Identifier: GPL-3.0-or-later
// The flips of Periodic_repair: those of Flip_repair (pictures: flip_repair.h), of lifted cells.
#include <annulus/engine/periodic_repair.h>

#include <array>
#include <cstddef>

namespace annulus::inline v1 {

template <>
bool Periodic_repair<2>::flip(Corner_index h) {
    const std::size_t i = work_.slot_of(h);
    const Lifted_cell<2> a{work_.cell_of(h), {}}, b = beyond<2>(work_, a, i);
    const Cell_images<2> x = work_.images(a.cell);
    const Image<2> q = x[i], u = x[(i + 1) % 3], w = x[(i + 2) % 3];
    const Image<2> p = work_.image(b.cell, work_.slot_of(work_.twin[a.cell][i]), b.shift);
    const std::array<Cell_images<2>, 2> came{{{q, u, p}, {p, w, q}}};
    for (const Cell_images<2>& cell : came)
        if (signs_.sign(cell) <= 0) return false;
    return replace(std::array{a, b}, came);
}

/// 2-3 where the edge of the opposite vertices p and q crosses the facet, 3-2 where it passes outside, 4-4 where four
/// points are coplanar and two edges cross. That the cells of a 2-3 or 3-2 flip are positive is tested first.
template <>
bool Periodic_repair<3>::flip(Corner_index h) {
    constexpr std::size_t facing[4][3] = {{2, 1, 3}, {0, 2, 3}, {1, 0, 3}, {0, 1, 2}};
    const std::size_t i = work_.slot_of(h);
    const Lifted_cell<3> a{work_.cell_of(h), {}}, b = beyond<3>(work_, a, i);
    const auto slot = [this](Lifted_cell<3> c, Image<3> s) { return work_.slot(c.cell, s, c.shift); };
    const auto opposite = [this](Lifted_cell<3> c, std::size_t k) {
        const Corner_index t = work_.twin[c.cell][k];
        return work_.image(work_.cell_of(t), work_.slot_of(t), c.shift + work_.translation(c.cell, k));
    };
    const Cell_images<3> corners = work_.images(a.cell);
    const Image<3> q = corners[i], p = opposite(a, i);
    std::array<Image<3>, 3> x;
    for (std::size_t k = 0; k < 3; ++k) x[k] = corners[facing[i][k]];
    std::array<Cell_images<3>, 3> around;  // the edge pq
    int beside = 0, how = 0;
    std::size_t odd = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        around[k] = {x[(k + 1) % 3], x[(k + 2) % 3], p, q};
        const int passes = signs_.sign(around[k]);
        if (passes > 0) continue;
        ++beside;
        odd = k;
        how = passes;
    }
    if (beside == 0) return replace(std::array{a, b}, around);
    if (beside > 1) return false;
    const Image<3> c = x[odd], u = x[(odd + 1) % 3], w = x[(odd + 2) % 3];
    const std::size_t c_in_a = slot(a, c), c_in_b = slot(b, c);
    const Lifted_cell<3> m = beyond<3>(work_, a, c_in_a), n = beyond<3>(work_, b, c_in_b);
    const Image<3> r = opposite(a, c_in_a);
    if (how < 0) {
        if (m != n || r != p) return false;
        return replace(std::array{a, b, m}, std::array<Cell_images<3>, 2>{{{c, q, p, w}, {q, c, p, u}}});
    }
    if (m == n || r == c || r != opposite(b, c_in_b) || beyond<3>(work_, m, slot(m, q)) != n) return false;
    const std::array<Cell_images<3>, 4> came{{{w, c, p, q}, {c, u, p, q}, {r, w, p, q}, {u, r, p, q}}};
    for (const Cell_images<3>& cell : came)
        if (signs_.sign(cell) <= 0) return false;
    return replace(std::array{a, b, m, n}, came);
}

}  // namespace annulus::inline v1
