// SPDX-License-Identifier: GPL-3.0-or-later
// Builder: the start of a build, and its result.
#include <annulus/kernel/builder.h>

#include <annulus/kernel/axis_across.h>
#include <annulus/mesh/parallel_runs.h>
#include <annulus/predicate/sure_orientation.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tuple>
#include <utility>

namespace annulus::inline v1 {

namespace {
constexpr std::size_t run = 1U << 14;  // vertices, or cells, that a thread takes at once
}

/// Scales positions by a power of two that makes `extent` nearly 1, unless that would round one of them; unscaled, the
/// filter only decides fewer cases.
template <int d>
double Builder<d>::take_positions(std::span<const Coordinates<d>> x, double extent, int threads) {
    const std::size_t n = order_.size();
    cells_.sites.resize(n + 1);
    cells_.infinity = static_cast<Rank>(n);
    cells_.sites[n] = {};
    const int shift = extent > 0 ? -std::ilogb(extent) : 0;
    const double scale = std::ldexp(1.0, shift);
    if (std::abs(shift) <= 1000 && copy_scaled(x, scale, std::ldexp(1.0, -shift), threads)) return scale;
    (void)copy_scaled(x, 1.0, 1.0, threads);
    return 1.0;
}

/// Whether no coordinate was rounded.
template <int d>
bool Builder<d>::copy_scaled(std::span<const Coordinates<d>> x, double scale, double back, int threads) {
    std::atomic<bool> all{true};
    for_each_run(order_.size(), run, threads, [&](std::size_t first, std::size_t last) {
        bool exact = true;
        for (std::size_t r = first; r < last; ++r) {
            const Coordinates<d>& p = x[static_cast<std::size_t>(order_[r])];
            auto& site = cells_.sites[r];
            for (std::size_t c = 0; c < d; ++c) {
                site.x[c] = p[c] * scale;
                exact = exact && site.x[c] * back == p[c];
            }
            site.grid = grid_scale<d>(site.x);
        }
        if (!exact) all = false;
    });
    return all;
}

/// The first d + 1 vertices that span the space, in positive order. Returns false if there are none.
template <int d>
bool Builder<d>::find_simplex() {
    Simplex& simplex = simplex_;
    const auto at = [this](Rank v) -> const Coordinates<d>& { return cells_.at(v); };
    const Rank infinity = cells_.infinity;
    simplex[0] = 0;
    std::size_t found = 1;
    for (Rank v = 1; v < infinity && found <= d; ++v) {
        simplex[found] = v;
        if (found == 1) {
            found += at(v) != at(0) ? 1U : 0U;
        } else if (found == d) {
            Tuple<d, d + 1> x;
            for (std::size_t k = 0; k <= d; ++k) x[k] = &at(simplex[k]);
            const int sign = sure_orientation<d>(x);
            if (sign < 0) std::swap(simplex[0], simplex[1]);
            found += sign != 0 ? 1U : 0U;
        } else if constexpr (d == 3) {
            found += axis_across(at(simplex[0]), at(simplex[1]), at(v)) ? 1U : 0U;
        }
    }
    return found > d;
}

/// The simplex, and the infinite cells behind its facets.
template <int d>
void Builder<d>::first_cells() {
    constexpr std::size_t expected = d == 2 ? 2 : 7;  // cells a vertex; threads leave some unused
    auto& cells = cells_.cells;
    cells_.make_room(expected * order_.size() + order_.size() / 8 + 64);
    cells_.used = corners + 1;
    cells[0].vertex = simplex_;
    for (std::size_t i = 0; i <= d; ++i) {
        // Infinity beyond the facet makes the simplex negative. An even number of exchanges takes it out of slot 0.
        auto& w = cells[i + 1].vertex = simplex_;
        w[i] = cells_.infinity;
        std::swap(w[i == 0 ? 1 : 0], w[i == d ? d - 1 : d]);
        if (i == 0) {
            std::swap(w[0], w[1]);
            std::swap(w[d - 1], w[d]);
        }
    }
    // Two of these cells share the facet without the corner that only the first one has.
    const auto slot_but = [&cells](Cell c, Cell other) {
        const auto& there = cells[other].vertex;
        std::size_t i = 0;
        while (std::find(there.begin(), there.end(), cells[c].vertex[i]) != there.end()) ++i;
        return static_cast<std::uint32_t>(i);
    };
    for (Cell c = 0; c < cells_.used; ++c) {
        for (Cell other = 0; other < cells_.used; ++other)
            if (c != other) cells[c].across[slot_but(c, other)] = 4 * other + slot_but(other, c);
        const Coordinates<d>& p = cells_.at(cells[c].vertex[0]);
        std::array<Lifted<d>, static_cast<std::size_t>(d)> l;
        for (std::size_t k = 0; k < d; ++k) l[k] = cells_.lifted(cells[c].vertex[k + 1], p);
        cells[c].sphere = std::apply([&](const auto&... b) { return cached_sphere(b..., cells_.bound(c)); }, l);
    }
    inserter_.begin(cells_);
}

/// First copies half-facets under their numbers here, since the new numbers are known only when all cells have one.
template <int d>
void Builder<d>::copy_to(Corner_table<d>& table, std::size_t bound, int threads) {
    const std::size_t count = cell_order_.group(cells_, threads);
    table.reserve(bound, count);
    table.reset_to(bound, count);
    const auto note = [&table](Cell_index c, const Cell_vertices<d>& vertices) {
        for (int i = 0; i <= d; ++i) table.set_corner(vertices[static_cast<std::size_t>(i)], table.corner(c, i));
    };
    cell_order_.number(cells_, threads, [&](std::size_t k, const Simplex& ranks, const auto& across) {
        const Cell_index c(static_cast<Index>(k));
        const Cell_vertices<d> vertices = named(ranks);
        std::array<Corner_index, corners> twins;
        for (std::size_t i = 0; i <= d; ++i) twins[i] = Corner_index(static_cast<Index>(across[i]));
        table.set_cell(c, vertices, twins);
    });
    for_each_run(count, run, threads, [&](std::size_t first, std::size_t last) {
        for (Cell_index c(static_cast<Index>(first)); c.offset() < last; ++c) {
            for (int i = 0; i <= d; ++i) {
                const Corner_index h = table.corner(c, i);
                table.set_twin_only(h, Corner_index(static_cast<Index>(
                                           cell_order_.renamed(static_cast<std::uint32_t>(table.twin(h).value())))));
            }
            if (threads == 1) note(c, cell_vertices(table, c));
        }
    });
    if (threads == 1) return;
    for (const Cell_index c : table.cells()) note(c, cell_vertices(table, c));
}

template class Builder<2>;
template class Builder<3>;

}  // namespace annulus::inline v1
