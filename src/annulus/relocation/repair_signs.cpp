// SPDX-License-Identifier: GPL-3.0-or-later
// Signs alone, by one circumsphere a cell: for when tolerances would not last.
#include <annulus/relocation/repair.h>

#include <annulus/certificate/circumcircle_2.h>
#include <annulus/certificate/circumsphere_3.h>

#include <algorithm>
#include <array>
#include <type_traits>
#include <utility>

namespace annulus {

namespace {

template <int d>
using Circumsphere = std::conditional_t<d == 2, Circumcircle_2, Circumsphere_3>;

}  // namespace

/// Every facet is asked from both sides if both are asked, because which side is to ask would be a branch that no processor
/// predicts, dearer than the answer. Returns how many halves of certificates are clear: 2 for the cell, 1 for each facet.
template <int d>
std::uint64_t Repair<d>::ask_signs(Index c) {
    const auto& t = embedding_.table();
    const Cell_points<d> v = cell_points(t, c);
    if (std::any_of(v.begin(), v.end(), [](Index w) { return w < 0; })) {
        for (int i = 0; i <= d; ++i) {
            const Index h = t.corner(c, i);
            if (v[static_cast<std::size_t>(i)] != infinite) suspect_facet(t.facet(h));  // a ridge
        }
        return 0;
    }
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
        const Circumsphere<d> sphere(x_[static_cast<std::size_t>(v[i])]...);
        const bool positive = sphere.positive();
        const std::array<Index, d + 1> opposite{t.vertex(t.twin(t.corner(c, static_cast<int>(i))))...};
        // At infinity a corner stands in, of which nothing can be said.
        const std::array<bool, d + 1> outside{
            sphere.excludes(x_[static_cast<std::size_t>(opposite[i] < 0 ? v[0] : opposite[i])])...};
        if ((int{positive} + ... + int{outside[i]}) == d + 2) [[likely]]
            return std::uint64_t{d + 3};
        if (!positive) suspect_cell(c);
        std::uint64_t clear = positive ? 2 : 0;
        for (std::size_t k = 0; k <= d; ++k) {
            if (opposite[k] == infinite) continue;
            if (positive && outside[k]) {
                ++clear;
            } else {
                suspect_facet(t.facet(t.corner(c, static_cast<int>(k))));
            }
        }
        return clear;
    }
    (std::make_index_sequence<d + 1>());
}

template <int d>
bool Repair<d>::evaluate_everything() {
    const auto& t = embedding_.table();
    everything_ = true;
    std::uint64_t clear = 0;
    for (Index c = 0; c < t.cell_bound(); ++c)
        if (t.is_cell(c)) clear += ask_signs(c);
    count_clear(clear);
    return evaluate();
}

template <int d>
bool Repair<d>::evaluate_star(Index v) {
    const auto& t = embedding_.table();
    std::uint64_t clear = 0;
    t.for_each_corner(v, [&](Index h) {
        const std::uint64_t found = ask_signs(Cell_table<d>::cell_of(h));
        clear += found;
        // The facet opposite v is asked from this side alone, so its one half is all of it. Where something is not clear, it
        // is taken to be something else: one certificate of the star too many is counted then at most.
        if (found != 0 && t.vertex(t.twin(h)) != infinite) ++clear;
    });
    count_clear(clear);
    return evaluate();
}

template <int d>
void Repair<d>::count_clear(std::uint64_t halves) {
    report_.evaluated += halves / 2;
    report_.arithmetic.filter += halves / 2;
}

template class Repair<2>;
template class Repair<3>;

}  // namespace annulus
