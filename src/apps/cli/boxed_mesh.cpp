// SPDX-License-Identifier: GPL-3.0-or-later
#include <apps/cli/boxed_mesh.h>

#include <algorithm>

namespace annulus::inline v1::cli {

namespace {

Periodic_strategy periodic_strategy_of(Strategy s) {
    return s == Strategy::tolerances  ? Periodic_strategy::tolerances
           : s == Strategy::automatic ? Periodic_strategy::automatic
                                      : Periodic_strategy::signs;
}

}  // namespace

template <int d>
Boxed_mesh<d>::Boxed_mesh(std::span<const std::uint64_t> id, std::span<const Coordinates<d>> x, const Box<d>& box,
                          const Options& options)
    : mesh_(x, box, {.threads = options.threads, .strategy = periodic_strategy_of(options.strategy)}),
      box_(box),
      id_(id.begin(), id.end()),
      rebuilds_(options.strategy == Strategy::rebuild) {
    path_.follow(id, x, box);
}

template <int d>
Move_result Boxed_mesh<d>::follow(std::span<const std::uint64_t> id, std::span<const Coordinates<d>> x,
                                  const Box<d>& box) {
    Move_result result;
    if (!rebuilds_ && std::equal(id.begin(), id.end(), id_.begin(), id_.end())) {
        result = mesh_.move_all(x, box);
    } else {
        mesh_ = Periodic_mesh<d>(x, box, mesh_.options());
        result.moves.asked = result.moves.rebuilt = x.size();
        id_.assign(id.begin(), id.end());
    }
    box_ = box;
    path_.follow(id, x, box);
    return result;
}

template class Boxed_mesh<2>;
template class Boxed_mesh<3>;

}  // namespace annulus::inline v1::cli
