// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_kept.h>

#include <annulus/arithmetic/environment.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

namespace annulus::inline v1 {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

/// Adapts a table for Voronoi_terms: its finite cells in its order are those of mesh_cells().
template <int d>
struct Cells_of_table {
    const Corner_table<d>& table;

    [[nodiscard]] Index corner(Index c, std::size_t i) const {
        return table.vertex(table.corner(Cell_index(c), static_cast<int>(i)));
    }
    [[nodiscard]] Index beyond(Index c, std::size_t i) const {
        return table.cell_of(table.twin(table.corner(Cell_index(c), static_cast<int>(i)))).value();
    }
    [[nodiscard]] bool is_finite(Index c) const { return !table.is_infinite(Cell_index(c)); }
};

}  // namespace

template <int d>
Kept_voronoi_volumes<d>::Kept_voronoi_volumes(Delaunay_mesh<d>& mesh) : mesh_(mesh) {
    mesh.table().set_dirty_cells(dirty_cells_);
}
template <int d>
Kept_voronoi_volumes<d>::~Kept_voronoi_volumes() {
    mesh_.table().clear_dirty_cells();
}

template <int d>
std::span<const double> Kept_voronoi_volumes<d>::update(std::span<const Coordinates<d>> x) {
    require_sound_environment();
    if (mesh_.dimension() != d) {
        if (mesh_.dimension() < 0 && mesh_.vertices() > 0) throw std::bad_alloc();
        note_flat(x.size());
        return volume_;
    }
    double largest = 0;
    for (std::size_t v = 0; v < x.size(); ++v)
        if (is_present(v))
            for (const double c : x[v]) largest = std::max(largest, std::fabs(c));
    const int exponent = largest == 0 ? 0 : std::ilogb(largest) + 1;
    bool afresh = x_.empty() || dirty_cells_.everything() || exponent != exponent_;
    exponent_ = exponent;
    std::vector<Index> moved;
    try {
        if (!afresh) {
            moved = note_moves(x);
            afresh = moved.size() > x.size() / 8;  // nearly all are affected
        }
        if (afresh) {
            x_.assign(x.begin(), x.end());
            const std::vector<Cell_index> cells = all_cells();
            volume_.assign(x.size(), nowhere);
            sum_.resize(x.size());
            centre_.resize(table().cell_bound().offset());
            find_circumcentres(cells);
            add_up(all_vertices(), cells);
        } else {
            std::vector<Cell_index> changed = cells_around(moved);
            const auto around_moved = static_cast<std::ptrdiff_t>(changed.size());
            for (const Cell_index c : dirty_cells_.cells())
                if (table().is_cell(c)) changed.push_back(c);
            std::sort(changed.begin() + around_moved, changed.end());
            std::inplace_merge(changed.begin(), changed.begin() + around_moved, changed.end());
            changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
            centre_.resize(table().cell_bound().offset());
            find_circumcentres(changed);
            const std::vector<Index> concerned = corners_of(changed);
            add_up(concerned, cells_around(concerned));
        }
    } catch (...) {
        x_.clear();
        throw;
    }
    dirty_cells_.clear();
    return volume_;
}

template <int d>
double Kept_voronoi_volumes<d>::scale() const {
    return std::ldexp(1.0, -exponent_);
}

/// No cell has d + 1 corners.
template <int d>
void Kept_voronoi_volumes<d>::note_flat(std::size_t bound) {
    x_.clear();
    computed_ = 0;
    volume_.resize(bound);
    for (std::size_t v = 0; v < bound; ++v) volume_[v] = is_present(v) ? unbounded : nowhere;
}

/// Vertices that moved or are new. Compares bits, because -0 and 0 are equal otherwise.
template <int d>
std::vector<Index> Kept_voronoi_volumes<d>::note_moves(std::span<const Coordinates<d>> x) {
    std::vector<Index> moved;
    const std::size_t before = x_.size();
    x_.resize(x.size());
    volume_.resize(x.size(), nowhere);
    sum_.resize(x.size());
    for (std::size_t v = 0; v < x.size(); ++v) {
        if (!is_present(v)) {
            volume_[v] = nowhere;
            continue;
        }
        if (v < before && std::memcmp(&x_[v], &x[v], sizeof x[v]) == 0) continue;
        x_[v] = x[v];
        moved.push_back(static_cast<Index>(v));
    }
    return moved;
}

template <int d>
std::vector<Index> Kept_voronoi_volumes<d>::all_vertices() const {
    std::vector<Index> out;
    out.reserve(mesh_.vertices());
    for (std::size_t v = 0; v < x_.size(); ++v)
        if (is_present(v)) out.push_back(static_cast<Index>(v));
    return out;
}

template <int d>
std::vector<Cell_index> Kept_voronoi_volumes<d>::all_cells() const {
    std::vector<Cell_index> out;
    out.reserve(table().cell_bound().offset());
    for (const Cell_index c : table().cells()) out.push_back(c);
    return out;
}

/// Every cell with one of these corners, infinite ones too, ascending: from star to star while these are few, otherwise
/// in one pass over all cells.
template <int d>
std::vector<Cell_index> Kept_voronoi_volumes<d>::cells_around(std::span<const Index> vertices) const {
    std::vector<Cell_index> out;
    if (vertices.size() < mesh_.vertices() / 64) {
        for (const Index v : vertices)
            table().for_each_corner(v, [&](Corner_index h) { out.push_back(table().cell_of(h)); });
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    }
    std::vector<char> wanted(x_.size(), 0);
    for (const Index v : vertices) wanted[at(v)] = 1;
    for (const Cell_index c : table().cells())
        for (int i = 0; i <= d; ++i)
            if (const Index v = table().vertex(table().corner(c, i)); v != infinite && wanted[at(v)] != 0) {
                out.push_back(c);
                break;
            }
    return out;
}

/// Each once, ascending, infinity left out.
template <int d>
std::vector<Index> Kept_voronoi_volumes<d>::corners_of(std::span<const Cell_index> cells) const {
    std::vector<char> met(x_.size(), 0);
    std::size_t count = 0;
    for (const Cell_index c : cells)
        for (int i = 0; i <= d; ++i)
            if (const Index v = table().vertex(table().corner(c, i)); v != infinite) {
                count += met[at(v)] == 0 ? 1 : 0;
                met[at(v)] = 1;
            }
    std::vector<Index> out;
    out.reserve(count);
    for (std::size_t v = 0; out.size() < count; ++v)
        if (met[v] != 0) out.push_back(static_cast<Index>(v));
    return out;
}

template <int d>
void Kept_voronoi_volumes<d>::find_circumcentres(std::span<const Cell_index> cells) {
    const double unit = scale();
    if (!std::isnormal(unit)) return;  // every coordinate is subnormal
    const Cells_of_table<d> of{table()};
    for (const Cell_index c : cells) {
        if (table().is_infinite(c)) continue;
        Corners<d> corners;
        std::array<Index, static_cast<std::size_t>(d + 1)> vertices{};
        for (std::size_t i = 0; i <= d; ++i) {
            vertices[i] = of.corner(c.value(), i);
            corners[i] = x_[at(vertices[i])];
        }
        centre_[c.offset()] = circumcentre_of<d>(vertices, corners, unit);
    }
}

/// Volumes of these vertices; `cells` are those around them and perhaps others. Terms added to sums of other vertices
/// on the way are never read.
template <int d>
void Kept_voronoi_volumes<d>::add_up(std::span<const Index> vertices, std::span<const Cell_index> around) {
    const double unit = scale();
    const bool normal = std::isnormal(unit);
    for (const Index v : vertices) {
        sum_[at(v)] = {0, normal ? 0 : unbounded};
        volume_[at(v)] = 0;
    }
    const Cells_of_table<d> cells{table()};
    const Voronoi_terms<d> terms(x_, centre_, unit, sum_);
    for (const Cell_index c : around) {
        if (!table().is_infinite(c)) {
            if (normal) terms.add_facets(cells, c.value());
            continue;
        }
        for (std::size_t i = 0; i <= d; ++i)
            if (const Index v = cells.corner(c.value(), i); v != infinite) volume_[at(v)] = unbounded;
    }
    for (const Index v : vertices)
        if (volume_[at(v)] != unbounded)
            volume_[at(v)] = sum_[at(v)].is_good() ? voronoi_volume<d>(sum_[at(v)], exponent_) : exact_volume(v);
    computed_ = vertices.size();
}

template <int d>
double Kept_voronoi_volumes<d>::exact_volume(Index v) const {
    const std::vector<Cell_index> around = cells_around(std::span(&v, 1));
    const Cells_of_table<d> of{table()};
    Mesh_cells<d> star;
    std::vector<std::size_t> numbers;
    for (const Cell_index c : around) {
        auto& corners = star.vertices.emplace_back();
        auto& beyond = star.neighbours.emplace_back();
        for (std::size_t i = 0; i <= d; ++i) {
            corners[i] = of.corner(c.value(), i);
            const auto found = std::lower_bound(around.begin(), around.end(), Cell_index(of.beyond(c.value(), i)));
            beyond[i] = found != around.end() && found->value() == of.beyond(c.value(), i)
                            ? static_cast<Index>(found - around.begin())
                            : star.outside;
        }
        numbers.push_back(numbers.size());
    }
    return exact_voronoi_volume<d>(x_, star, v, numbers);
}

template class Kept_voronoi_volumes<2>;
template class Kept_voronoi_volumes<3>;

}  // namespace annulus::inline v1
