// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <annulus/kernel/cached_sphere.h>
#include <annulus/kernel/default_init_vector.h>
#include <annulus/predicate/integer_signs.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace annulus::inline v1 {

/// A triangulation while Builder makes it. Vertices are ranks in the order of insertion; the last rank is infinity. A
/// cell is one line of 64 bytes with its sphere. Memory is kept from one build to the next.
template <int d>
struct Growing_cells {
    using Rank = std::int32_t;
    using Cell = std::uint32_t;        ///< its place in cells
    using Half_facet = std::uint32_t;  ///< 4 * cell + slot
    static constexpr Cell no_cell = ~Cell{0};
    static constexpr std::size_t most_cells = std::size_t{1} << 30;  ///< the most whose half-facets have an index
    static constexpr std::size_t corners = d + 1;

    struct Shape {
        std::array<Rank, corners> vertex;
        std::array<Half_facet, corners> across;
        Cached_sphere<d> sphere;
    };
    struct Shape_with_bound : Shape {
        float bound;
    };
    /// In 2D the line has room for the bound.
    struct alignas(64) Cell_data : std::conditional_t<d == 2, Shape_with_bound, Shape> {};
    /// A position and its scale (grid_scale).
    struct alignas(32) Site {
        Coordinates<d> x;
        double grid;
    };

    Default_init_vector<Site> sites;  // by rank
    Default_init_vector<Cell_data> cells;
    Default_init_vector<float> bounds;  // of cells in 3D
    std::size_t used = 0;               // cells below are in use or free
    Rank infinity = 0;

    /// The bound of the sphere of a cell; negative when the cell is in the cavity, or gone.
    [[nodiscard]] float& bound(Cell c) {
        if constexpr (d == 2) return cells[c].bound;
        else return bounds[c];
    }
    [[nodiscard]] float bound(Cell c) const {
        if constexpr (d == 2) return cells[c].bound;
        else return bounds[c];
    }
    [[nodiscard]] bool is_cell(Cell c) const { return bound(c) > 0; }
    /// The limit of `used`, at most most_cells. The bounds grow last, so that this is right even after bad_alloc.
    [[nodiscard]] std::size_t room() const { return d == 2 ? cells.size() : bounds.size(); }
    void make_room(std::size_t most) {
        most = std::min(most, most_cells);
        if (most <= room()) return;
        cells.resize(std::max(most, cells.size()));
        if constexpr (d == 3) bounds.resize(most);
    }

    [[nodiscard]] const Coordinates<d>& at(Rank v) const { return sites[static_cast<std::size_t>(v)].x; }
    [[nodiscard]] Scaled_point<d> on_grid(Rank v) const {
        const Site& s = sites[static_cast<std::size_t>(v)];
        return {&s.x, s.grid};
    }
    [[nodiscard]] Lifted<d> lifted(Rank v, const Coordinates<d>& p) const {
        return v == infinity ? Lifted<d>() : Lifted<d>(at(v), p);
    }
    [[nodiscard]] int slot_of_infinity(const Cell_data& c) const {
        for (int i = 0; i <= d; ++i)
            if (c.vertex[static_cast<std::size_t>(i)] == infinity) return i;
        return -1;
    }
    /// The value of the cached sphere of c at q.
    [[nodiscard]] auto look(Cell c, const Coordinates<d>& q) const {
        const Cell_data& cell = cells[c];
        return cell.sphere.at(Lifted<d>(q, at(cell.vertex[0])).from, std::fabs(bound(c)));
    }
};

/// The slot k places after `slot`, cyclically; k <= d.
template <int d>
constexpr std::uint32_t next_slot(std::uint32_t slot, std::uint32_t k) {
    return d == 3 ? (slot + k) & 3U : (slot + k < 3 ? slot + k : slot + k - 3);
}

/// The other corners of slot i: a point followed by them has the orientation that the cell has with the point in slot
/// i.
template <int d>
constexpr auto facing() {
    if constexpr (d == 2) return std::array<std::array<std::uint8_t, 2>, 3>{{{1, 2}, {2, 0}, {0, 1}}};
    else return std::array<std::array<std::uint8_t, 3>, 4>{{{1, 2, 3}, {0, 3, 2}, {3, 0, 1}, {2, 1, 0}}};
}

}  // namespace annulus::inline v1
