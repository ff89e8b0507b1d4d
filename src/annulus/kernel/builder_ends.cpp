// SPDX-License-Identifier: GPL-3.0-or-later
// Builder: how it begins, and what it hands over.
#include <annulus/kernel/builder.h>

#include <annulus/kernel/axis_across.h>
#include <annulus/kernel/bounding_box.h>
#include <annulus/mesh/walk.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <tuple>
#include <utility>

namespace annulus {

template <int d>
void Builder<d>::throw_too_large() {
    throw Error(Error_code::too_large, "more than " + std::to_string(Horizons::cells) + " cells");
}

template <int d>
void Builder<d>::take_positions(std::span<const Coordinates<d>> x) {
    const std::size_t n = order_.size();
    sites_.resize(n + 1);
    infinity_ = static_cast<Rank>(n);
    sites_[n].x = {};
    for (std::size_t r = 0; r < n; ++r) sites_[r].x = x[static_cast<std::size_t>(order_[r])];
    scale_positions(Bounding_box<d>(x, order_).extent());
    grid_.resize(n);
    for (std::size_t r = 0; r < n; ++r) grid_[r] = grid_scale<d>(sites_[r].x);
}

/// By a power of two that makes `extent` nearly 1, where that rounds none of them: where it does, the filter just knows
/// less.
template <int d>
void Builder<d>::scale_positions(double extent) {
    const std::size_t n = static_cast<std::size_t>(infinity_);
    if (!(extent > 0)) return;
    const int shift = -std::ilogb(extent);
    if (shift == 0 || std::abs(shift) > 1000) return;
    const double scale = std::ldexp(1.0, shift), back = std::ldexp(1.0, -shift);
    for (std::size_t r = 0; r < n; ++r)
        for (const double c : sites_[r].x)
            if (c * scale * back != c) return;
    for (std::size_t r = 0; r < n; ++r)
        for (double& c : sites_[r].x) c *= scale;
}

/// d + 1 vertices that span the space, the first ones that there are, in positive order. False: there are none.
template <int d>
bool Builder<d>::find_simplex(std::array<Rank, corners>& simplex) const {
    simplex[0] = 0;
    std::size_t found = 1;
    for (Rank v = 1; v < infinity_ && found <= d; ++v) {
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

/// The simplex, and the cells at infinity behind its facets.
template <int d>
void Builder<d>::first_cells(const std::array<Rank, corners>& simplex) {
    free_.clear();
    ridges_.begin(static_cast<std::size_t>(infinity_) + 1);
    constexpr std::size_t expected = d == 2 ? 2 : 7, more = 64;  // cells a vertex
    const std::size_t room = expected * static_cast<std::size_t>(infinity_) + more;
    if (bound_.size() < room) grow_cells(room);
    used_ = corners + 1;
    cells_[0].vertex = simplex;
    for (std::size_t i = 0; i <= d; ++i) {
        // Infinity beyond the facet makes the simplex negative; an even number of exchanges takes it out of slot 0.
        auto& w = cells_[i + 1].vertex = simplex;
        w[i] = infinity_;
        std::swap(w[i == 0 ? 1 : 0], w[i == d ? d - 1 : d]);
        if (i == 0) {
            std::swap(w[0], w[1]);
            std::swap(w[d - 1], w[d]);
        }
    }
    const auto facet = [this](Cell c, std::size_t slot) {
        auto w = cells_[c].vertex;
        w[slot] = -1;
        std::sort(w.begin(), w.end());
        return w;
    };
    for (Cell c = 0; c < used_; ++c) {
        for (Cell other = 0; other < used_; ++other)
            for (std::size_t i = 0; i <= d; ++i)
                for (std::size_t j = 0; j <= d; ++j)
                    if (c != other && facet(c, i) == facet(other, j))
                        cells_[c].across[i] = 4 * other + static_cast<Half_facet>(j);
        const Coordinates<d>& p = at(cells_[c].vertex[0]);
        std::array<Lifted<d>, static_cast<std::size_t>(d)> l;
        for (std::size_t k = 0; k < d; ++k) l[k] = lifted(cells_[c].vertex[k + 1], p);
        cells_[c].sphere = std::apply([&](const auto&... b) { return kept_sphere(b..., bound_[c]); }, l);
    }
}

template <int d>
void Builder<d>::number_cells() {
    if (number_.size() < used_) number_.resize(used_);
    for (std::size_t c = 0; c < used_; ++c) {
        number_[c] = count_;
        count_ += bound_[c] > 0 ? 1U : 0U;
    }
    if (count_ > static_cast<std::size_t>(Horizons::cells)) throw_too_large();
}

template <int d>
void Builder<d>::copy_to(Cell_table<d>& table, std::size_t bound) const {
    table.reserve(bound, count_);
    table.clear(bound, count_);
    for_each_cell([&table](Cell_index c, const Cell_points<d>& vertices, const auto& twins) {
        for (int i = 0; i <= d; ++i) {
            table.set_vertex_only(table.corner(c, i), vertices[static_cast<std::size_t>(i)]);
            table.set_twin_only(table.corner(c, i), twins[static_cast<std::size_t>(i)]);
        }
    });
    table.note_corners();
}

template class Builder<2>;
template class Builder<3>;

}  // namespace annulus
