// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/pair_changes.h>

#include <algorithm>
#include <utility>

namespace annulus::inline v1::cli {

namespace {

/// Of a point and its own image both directions are one pair.
template <class Turns>
void choose_direction(Turns& turns) {
    if (turns > Turns{}) return;
    for (auto& t : turns) t = -t;
}

}  // namespace

template <int d>
std::vector<Pair_change<d>> Pair_changes<Boxed_mesh<d>>::take(const Boxed_mesh<d>& dt,
                                                              std::span<const Facet_pair<d>> pairs) {
    for (Known& k : before_) {
        const auto old = std::exchange(k.path, {});
        for (std::size_t j = 0; j < d; ++j)
            for (std::size_t i = 0; i < d; ++i) k.path[i] += old[j] * dt.path().basis()[j][i];
        if (k.first == k.second) choose_direction(k.path);
    }
    std::sort(before_.begin(), before_.end());
    std::vector<Known> now;
    now.reserve(pairs.size());
    for (const Facet_pair<d>& p : pairs) {
        const std::uint64_t first = dt.ids()[static_cast<std::size_t>(p.first)];
        const std::uint64_t second = dt.ids()[static_cast<std::size_t>(p.second)];
        now.push_back({first, second, shift_of_paths(dt.path(), p.first, p.second, p.shift), p.shift});
    }
    std::sort(now.begin(), now.end());
    std::vector<Pair_change<d>> result;
    auto a = before_.begin();
    auto b = now.begin();
    const auto add = [&result](const Known& k, bool made) { result.push_back({k.first, k.second, k.shift, made}); };
    while (a != before_.end() || b != now.end()) {
        if (b == now.end() || (a != before_.end() && *a < *b)) add(*a++, false);
        else if (a == before_.end() || *b < *a) add(*b++, true);
        else ++a, ++b;
    }
    before_ = std::move(now);
    return result;
}

template class Pair_changes<Boxed_mesh<2>>;
template class Pair_changes<Boxed_mesh<3>>;

}  // namespace annulus::inline v1::cli
