// SPDX-License-Identifier: GPL-3.0-or-later
#include <annulus/measure/voronoi_kept.h>

#include <annulus/arithmetic/environment.h>
#include <annulus/measure/cells_of_table.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <new>

namespace annulus::inline v1 {

namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();
constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();

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
            afresh = is_most(moved.size());
        }
        if (afresh) {
            x_.assign(x.begin(), x.end());
            compute_all();
        } else compute_around(moved);
    } catch (...) {
        x_.clear();
        throw;
    }
    dirty_cells_.clear();
    return volume_;
}

template <int d>
void Kept_voronoi_volumes<d>::compute_all() {
    constexpr std::size_t batch = 128;  // of cells, so that what both loops read stays in the cache
    const std::vector<Cell_index> cells = all_cells();
    const std::vector<Index> vertices = all_vertices();
    volume_.assign(x_.size(), nowhere);
    sum_.resize(x_.size());
    centre_.resize(table().cell_bound().offset());
    clear_sums(vertices);
    for (std::size_t k = 0; k < cells.size(); k += batch) {
        const auto next = std::span(cells).subspan(k, std::min(batch, cells.size() - k));
        find_circumcentres(next);
        add_terms(next);
    }
    find_volumes(vertices, cells);
}

/// Volumes that these vertices and the dirty cells affect.
template <int d>
void Kept_voronoi_volumes<d>::compute_around(std::span<const Index> moved) {
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
    const std::vector<Cell_index> around = cells_around(concerned);
    clear_sums(concerned);
    add_terms(around);
    find_volumes(concerned, around);
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

/// Vertices that moved or are new, until they are so many that nearly all volumes are affected. Compares bits, because
/// -0 and 0 are equal otherwise.
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
        if (is_most(moved.size())) break;
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

template <int d>
void Kept_voronoi_volumes<d>::clear_sums(std::span<const Index> vertices) {
    const Voronoi_sum empty{0, std::isnormal(scale()) ? 0 : unbounded};
    for (const Index v : vertices) {
        sum_[at(v)] = empty;
        volume_[at(v)] = 0;
    }
}

/// Adds the terms of the facets that these cells own.
template <int d>
void Kept_voronoi_volumes<d>::add_terms(std::span<const Cell_index> cells) {
    if (!std::isnormal(scale())) return;
    Voronoi_terms<d>(x_, centre_, scale(), sum_).add_facets(Cells_of_table<d>{table()}, cells);
}

/// Volumes of these vertices from their sums; `around` are the cells around them and perhaps others. Sums of other
/// vertices, to which terms were added on the way, are never read.
template <int d>
void Kept_voronoi_volumes<d>::find_volumes(std::span<const Index> vertices, std::span<const Cell_index> around) {
    for (const Cell_index c : around)
        if (table().is_infinite(c))
            for (int i = 0; i <= d; ++i)
                if (const Index v = table().vertex(table().corner(c, i)); v != infinite) volume_[at(v)] = unbounded;
    const Volume_unit<d> unit(exponent_);
    for (const Index v : vertices)
        if (volume_[at(v)] != unbounded)
            volume_[at(v)] = sum_[at(v)].is_good() ? unit.volume(sum_[at(v)]) : exact_volume(v);
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
