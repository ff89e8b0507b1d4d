// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// The C++ standard that every header here needs. Every public header in C++ includes this one first, so that a compiler
// with an older standard reports this error, not errors about the standard library.
#if __cplusplus < 202002L
#error "annulus: compile with -std=c++20 or a later standard"
#endif

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace annulus::inline v1 {

/// Position of a point in R^d, in the caller's unit of length: plain doubles, no invariant.
template <int d>
using Coordinates = std::array<double, static_cast<std::size_t>(d)>;

/// Index of a vertex in input order. 32 bits: at most 2^29 cells. Cells and corners of a Corner_table have their own
/// types (internal/index.h).
using Index = std::int32_t;

/// The vertex at infinity.
inline constexpr Index infinite = -1;
/// No vertex at all, not even infinity: pads arrays that have more entries than vertices.
inline constexpr Index none = -2;

/// The stage of the filtered predicate that gave an answer, cheapest first.
enum class Stage : std::uint8_t {
    filter,    ///< round to nearest with a proved error bound
    interval,  ///< interval arithmetic
    exact,     ///< integers, directed rounding only in the last division and square roots
};

[[nodiscard]] constexpr std::string_view name_of(Stage s) {
    return s == Stage::filter ? "filter" : s == Stage::interval ? "interval" : "exact";
}

/// How many answers each stage gave.
struct Stage_counts {
    std::uint64_t filter = 0;
    std::uint64_t interval = 0;
    std::uint64_t exact = 0;

    void count(Stage s) noexcept { ++(s == Stage::filter ? filter : s == Stage::interval ? interval : exact); }
    [[nodiscard]] std::uint64_t total() const noexcept { return filter + interval + exact; }
    Stage_counts& operator+=(const Stage_counts& o) noexcept {
        filter += o.filter;
        interval += o.interval;
        exact += o.exact;
        return *this;
    }
    friend bool operator==(const Stage_counts&, const Stage_counts&) = default;
};

/// The finite cells of a triangulation, numbered 0, 1, 2 .., and their adjacency.
template <int d>
struct Mesh_cells {
    static constexpr Index outside = -1;  ///< instead of a neighbour: beyond the hull
    /// d + 1 vertex indices for each cell, positively oriented: counter-clockwise in 2D; in 3D the first three turn
    /// left as seen from the fourth, so that det(b - a, c - a, e - a) > 0. Padded with `none` where all points are in
    /// a plane or on a line.
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> vertices;
    /// The cell beyond the facet opposite to each vertex; `outside` beyond the hull, and everywhere where all points
    /// are in a plane or on a line.
    std::vector<std::array<Index, static_cast<std::size_t>(d + 1)>> neighbours;
};

/// The finite cells of a triangulation at one time. Nothing changes them afterwards, so they may be shared.
template <int d>
struct Cell_lists {
    /// `cells` are those of points of this affine dimension, with vertices below `bound`. O(n).
    Cell_lists(Mesh_cells<d> cells, int dimension, std::size_t bound);

    Mesh_cells<d> cells;         ///< where the points are in a plane or on a line: padded simplices of that dimension
    int dimension;               ///< affine dimension of the points; -1 without points
    std::vector<Index> cell_of;  ///< by vertex: the first cell at it; -1 without one, and unless `dimension` is d
};

/// For every vertex the vertices that an edge joins to it, in ascending order, all lists in one array: those of v are
/// index[begin[v]] to index[begin[v + 1] - 1].
struct Vertex_neighbours {
    std::vector<Index> begin;  ///< one entry more than there are indices of vertices
    std::vector<Index> index;

    /// Valid as long as this object is not changed.
    [[nodiscard]] std::span<const Index> of(Index v) const {
        const auto k = static_cast<std::size_t>(v);
        return {index.data() + begin[k], static_cast<std::size_t>(begin[k + 1] - begin[k])};
    }
};

/// What the certificates of a triangulation measure at given positions, in the caller's unit of length.
struct Measures {
    std::vector<double> tolerance;      ///< by vertex index: least certified tolerance of its certificates; infinite
                                        ///< where the points are flat, NaN at free indices
    std::vector<double> annulus_width;  ///< certified width of the annulus of every finite bi-cell: the standard one
                                        ///< in 2D, the least of four in 3D
    double theta_min = 1.5707963267948966;  ///< least theta of a finite bi-cell in radians
};

/// What became of the vertices that a call was to move; the last five add up to the first.
struct Move_counts {
    std::uint64_t asked = 0;
    std::uint64_t within_tolerance = 0;  ///< proved by the tolerance alone (or at rest): nothing was evaluated
    std::uint64_t kept_in_place = 0;     ///< tolerance failed, the certificates were evaluated and hold
    std::uint64_t flipped = 0;           ///< a certificate was violated and flips repaired it
    std::uint64_t reinserted = 0;        ///< removed and inserted again
    std::uint64_t rebuilt = 0;           ///< the triangulation was rebuilt

    Move_counts& operator+=(const Move_counts& o) noexcept {
        asked += o.asked;
        within_tolerance += o.within_tolerance;
        kept_in_place += o.kept_in_place;
        flipped += o.flipped;
        reinserted += o.reinserted;
        rebuilt += o.rebuilt;
        return *this;
    }
    friend bool operator==(const Move_counts&, const Move_counts&) = default;
};

/// What a call cost. Not a stable interface: it follows the strategies, so members may go, come, and count otherwise
/// in the next version. Star walks, recomputations of tolerances, cost, and steps by tolerances or signs are counted
/// by `tolerances`, `tolerances-each`, `auto` and `in-place` alone; cost also where `paper` has to rebuild everything.
struct Move_statistics {
    Stage_counts arithmetic;            ///< stage that decided, per certificate evaluated
    std::uint64_t evaluated = 0;        ///< certificates evaluated
    std::uint64_t star_walks = 0;       ///< failed vertices all of whose certificates had to be tested
    std::uint64_t requeued = 0;         ///< paper: vertices queued because another vertex lowered their tolerance
    std::uint64_t flips = 0;            ///< flips that were kept
    std::uint64_t undone_flips = 0;     ///< flips that were undone because they led nowhere
    std::uint64_t tolerance_steps = 0;  ///< time steps that began with tolerances
    std::uint64_t sign_steps = 0;       ///< time steps that began with the signs of all certificates
    std::uint64_t rebuild_steps = 0;    ///< auto: time steps that were rebuilt at once
    std::uint64_t tolerance_recomputations = 0;  ///< times that all tolerances were computed
    double cost = 0.0;                           ///< of the call, in cells tested, by measured costs (cost_model.h)

    Move_statistics& operator+=(const Move_statistics& o) noexcept {
        arithmetic += o.arithmetic;
        evaluated += o.evaluated;
        star_walks += o.star_walks;
        requeued += o.requeued;
        flips += o.flips;
        undone_flips += o.undone_flips;
        tolerance_steps += o.tolerance_steps;
        sign_steps += o.sign_steps;
        rebuild_steps += o.rebuild_steps;
        tolerance_recomputations += o.tolerance_recomputations;
        cost += o.cost;
        return *this;
    }
    friend bool operator==(const Move_statistics&, const Move_statistics&) = default;
};

/// What a call of `move`, `move_all`, `insert` or `remove` changed.
struct Move_result {
    Move_counts moves;
    /// On request (Options::report_changes): the cells that came and those that went, d + 1 vertices per cell, -1 for
    /// the vertex at infinity. No cell is in both lists (a cell that was turned over is another one), except where
    /// all points are in a plane or on a line before or after the call: then the lists are every finite cell there is
    /// and there was (padded with -2, `none`).
    std::vector<Index> changed, gone;
    Move_statistics statistics;

    Move_result& operator+=(const Move_result& o) {
        moves += o.moves;
        changed.insert(changed.end(), o.changed.begin(), o.changed.end());
        gone.insert(gone.end(), o.gone.begin(), o.gone.end());
        statistics += o.statistics;
        return *this;
    }
};

extern template struct Cell_lists<2>;
extern template struct Cell_lists<3>;

}  // namespace annulus::inline v1
