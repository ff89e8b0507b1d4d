// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/measure/neighbour_changes.h>
#include <annulus/moving_mesh.h>
#include <apps/cli/frame_measures.h>

#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

namespace annulus::inline v1::cli {

/// A pair of neighbours that was made or broken, by ids.
template <int d>
struct Pair_change {
    std::uint64_t first = 0, second = 0;
    Shift<d> shift{};  ///< as in the frame that has the pair: this one where it was made, else the one before
    bool made = false;
};

/// The neighbour pairs that a frame made and broke.
template <class Moving>
class Pair_changes;

/// Of an open mesh: from the cells that its calls created and removed.
template <int d>
class Pair_changes<Moving_mesh<d>> {
  public:
    void name(Index v, std::uint64_t id) { changes_.name(v, id); }
    void note(const Move_result& report) { changes_.note(report.changed, report.gone); }
    /// Since the last call. `pairs` are not read.
    [[nodiscard]] std::vector<Pair_change<d>> take(const Moving_mesh<d>&, std::span<const Facet_pair<d>>) {
        std::vector<Pair_change<d>> result;
        for (const Neighbour_change& c : changes_.take()) result.push_back({c.first, c.second, {}, c.made});
        return result;
    }

  private:
    Neighbour_changes<d> changes_;
};

/// Of a periodic mesh: from its pairs before and after. The paths of points say which pairs are the same, whatever
/// images the frames have.
template <int d>
class Pair_changes<Boxed_mesh<d>> {
  public:
    void name(Index, std::uint64_t) {}
    void note(const Move_result&) {}
    /// Since the last call; ascending. To be called for every frame, with its pairs. O(p log p).
    [[nodiscard]] std::vector<Pair_change<d>> take(const Boxed_mesh<d>& dt, std::span<const Facet_pair<d>> pairs);

  private:
    struct Known {
        std::uint64_t first, second;
        typename Image_path<d>::Turns path;  ///< the shift between the paths
        Shift<d> shift;                      ///< between the positions in the frame

        friend bool operator<(const Known& a, const Known& b) {
            return std::tie(a.first, a.second, a.path) < std::tie(b.first, b.second, b.path);
        }
    };
    std::vector<Known> before_;
};

extern template class Pair_changes<Boxed_mesh<2>>;
extern template class Pair_changes<Boxed_mesh<3>>;

}  // namespace annulus::inline v1::cli
